#include "preview/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace citykiln::preview {
namespace {

// The dimensions of PixelSamples that are stratified.
constexpr std::uint32_t kOrderedDimensions = 20;

// How many of the 2^k boxes of 2^-a by 2^(a-k) hold a point, summed over all shapes; each should hold one.
int boxes_hit(const std::vector<UnitPair>& points, int k) {
  int hit = 0;
  for (int a = 0; a <= k; ++a) {
    std::set<std::pair<int, int>> boxes;
    for (const UnitPair& p : points)
      boxes.insert({static_cast<int>(std::ldexp(p.u, a)), static_cast<int>(std::ldexp(p.v, k - a))});
    hit += static_cast<int>(boxes.size());
  }
  return hit;
}

std::vector<UnitPair> first_points(const PixelSamples& pixel, std::uint32_t count, std::uint32_t dimension) {
  std::vector<UnitPair> points;
  for (std::uint32_t i = 0; i < count; ++i) points.push_back(pixel.pair(i, dimension));
  return points;
}

TEST(PixelSamples, LieInTheUnitSquare) {
  const SampleGrid grid = grid_of(100, 60, 16);
  for (std::uint32_t x = 0; x < 100; x += 7) {
    const PixelSamples pixel(1, x, 59, grid);
    for (std::uint32_t dimension = 0; dimension < 30; ++dimension)
      for (const UnitPair& p : first_points(pixel, 16, dimension)) {
        EXPECT_TRUE(p.u >= 0 && p.u < 1) << p.u;
        EXPECT_TRUE(p.v >= 0 && p.v < 1) << p.v;
      }
  }
}

TEST(PixelSamples, AllOfAPixelAreOneInEveryBox) {
  for (const int k : {0, 1, 2, 3, 4, 5, 6}) {
    const SampleGrid grid = grid_of(320, 200, 1 << k);
    for (std::uint32_t dimension = 0; dimension < kOrderedDimensions; ++dimension) {
      const PixelSamples pixel(7, 200, 3 + dimension, grid);
      EXPECT_EQ(boxes_hit(first_points(pixel, 1u << k, dimension), k), (k + 1) << k) << k << " " << dimension;
    }
  }
}

// Digits are base 4: any power of four of the first samples is stratified.
TEST(PixelSamples, TheFirstPowersOfFourAreOneInEveryBox) {
  const SampleGrid grid = grid_of(64, 64, 256);
  for (std::uint32_t dimension = 0; dimension < kOrderedDimensions; ++dimension)
    for (const int k : {2, 4, 6})
      EXPECT_EQ(boxes_hit(first_points(PixelSamples(3, 11, 40, grid), 1u << k, dimension), k), (k + 1) << k);
}

// Stratification across pixels turns the error into fine grain instead of clumps.
TEST(PixelSamples, SquaresOfPixelsAreOneInEveryBoxTogether) {
  const SampleGrid grid = grid_of(64, 64, 1);
  for (std::uint32_t dimension = 0; dimension < kOrderedDimensions; ++dimension) {
    std::vector<UnitPair> points;
    for (std::uint32_t y = 24; y < 32; ++y)
      for (std::uint32_t x = 40; x < 48; ++x) points.push_back(PixelSamples(5, x, y, grid).pair(0, dimension));
    EXPECT_EQ(boxes_hit(points, 6), 7 << 6) << dimension;
  }
}

TEST(PixelSamples, MeansAreAHalfInEveryDimension) {
  const SampleGrid grid = grid_of(32, 32, 4);
  for (std::uint32_t dimension = 0; dimension < 30; ++dimension) {
    double u = 0, v = 0, uv = 0;
    for (std::uint32_t y = 0; y < 32; ++y)
      for (std::uint32_t x = 0; x < 32; ++x)
        for (const UnitPair& p : first_points(PixelSamples(9, x, y, grid), 4, dimension))
          u += p.u, v += p.v, uv += p.u * p.v;
    // six deviations of plain chance: 1/sqrt(12 n) and 7/144 for the product
    constexpr double kPoints = 32 * 32 * 4, kNear = 6 * 0.2887 / 64;
    EXPECT_NEAR(u / kPoints, 0.5, kNear) << dimension;
    EXPECT_NEAR(v / kPoints, 0.5, kNear) << dimension;
    EXPECT_NEAR(uv / kPoints, 0.25, kNear) << dimension;
  }
}

TEST(PixelSamples, DimensionsDoNotFollowEachOther) {
  const SampleGrid grid = grid_of(32, 32, 1);
  for (std::uint32_t dimension = 0; dimension < 24; ++dimension) {
    double sum = 0;
    for (std::uint32_t y = 0; y < 32; ++y)
      for (std::uint32_t x = 0; x < 32; ++x) {
        const PixelSamples pixel(2, x, y, grid);
        sum += (pixel.pair(0, dimension).u - 0.5) * (pixel.pair(0, dimension + 1).u - 0.5);
      }
    // five deviations of plain chance: 1/12 / sqrt(1024)
    EXPECT_LT(std::abs(sum / 1024), 5.0 / 12 / 32) << dimension;
  }
}

TEST(PixelSamples, AreAFunctionOfSeedPixelSampleAndDimension) {
  const SampleGrid grid = grid_of(640, 360, 4);
  const UnitPair p = PixelSamples(1, 5, 6, grid).pair(2, 3);
  EXPECT_EQ(p.u, PixelSamples(1, 5, 6, grid).pair(2, 3).u);
  EXPECT_NE(p.u, PixelSamples(2, 5, 6, grid).pair(2, 3).u);
  EXPECT_NE(p.u, PixelSamples(1, 6, 5, grid).pair(2, 3).u);
  EXPECT_NE(p.u, PixelSamples(1, 5, 6, grid).pair(1, 3).u);
  EXPECT_NE(p.u, PixelSamples(1, 5, 6, grid).pair(2, 4).u);
}

TEST(SampleGrid, IsTheSmallestThatHoldsThePicture) {
  EXPECT_EQ(grid_of(512, 3, 64).log2_side, 9);
  EXPECT_EQ(grid_of(3, 513, 65).log2_side, 10);
  EXPECT_EQ(grid_of(3, 513, 65).log2_samples, 7);
  EXPECT_EQ(grid_of(0, -1, 0).log2_side, 0);
  EXPECT_EQ(grid_of(0, -1, 0).log2_samples, 0);
}

}  // namespace
}  // namespace citykiln::preview
