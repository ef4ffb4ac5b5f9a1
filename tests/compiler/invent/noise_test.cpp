#include "compiler/invent/land/noise.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

namespace citykiln::invent {
namespace {

TEST(Noise, HashesOfPlacesOnADiagonalDiffer) {
  // a hash of x + y alone makes stripes
  std::set<std::uint64_t> hashes;
  for (int i = 0; i < 1000; ++i) hashes.insert(hash_of(i, 1000 - i, 5));
  EXPECT_EQ(hashes.size(), 1000U);
}

TEST(Noise, AChangedBitChangesHalfOfTheHash) {
  double changed = 0;
  constexpr int kPlaces = 200;
  for (int i = 0; i < kPlaces; ++i)
    for (int bit = 0; bit < 20; ++bit) changed += std::popcount(hash_of(i, 7, 1) ^ hash_of(i ^ (1 << bit), 7, 1));
  EXPECT_NEAR(changed / (kPlaces * 20), 32, 0.5);
}

TEST(Noise, PerlinIsZeroOnWholeCoordinatesAndBounded) {
  double sum = 0, most = 0;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      EXPECT_EQ(perlin({static_cast<double>(i), static_cast<double>(j)}, 9), 0);
      const double value = perlin({i * 0.37, j * 0.41}, 9);
      sum += value;
      most = std::max(most, std::abs(value));
    }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.5);
  EXPECT_NEAR(sum / 1600, 0, 0.06);
}

TEST(Noise, PerlinIsNotStriped) {
  // the mean difference along one diagonal is about that along the other
  double rising = 0, falling = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{i * 0.613, i * 0.277};
    rising += std::abs(perlin(p + Vec2{0.5, 0.5}, 4) - perlin(p, 4));
    falling += std::abs(perlin(p + Vec2{0.5, -0.5}, 4) - perlin(p, 4));
  }
  EXPECT_NEAR(rising / falling, 1, 0.15);
}

TEST(Noise, RidgedNoiseIsFromZeroToOne) {
  for (int i = 0; i < 2000; ++i) {
    const double value = ridged_noise({i * 0.173, i * 0.091}, 5, 2);
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
  }
}

}  // namespace
}  // namespace citykiln::invent
