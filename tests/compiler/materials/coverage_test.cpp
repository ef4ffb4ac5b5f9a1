#include "compiler/materials/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "compiler/geometry/trig.h"

namespace citykiln::materials {
namespace {

double sum_of(const Coverage& cover) {
  double sum = 0;
  for (const double share : cover.share) sum += share;
  return sum;
}

// Star-shaped around a point, and therefore simple.
Ring random_star(std::mt19937& random, Vec2 middle, double reach_m) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int corners = 3 + static_cast<int>(unit(random) * 9);
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(middle +
                   direction_of((i + 0.9 * unit(random)) / corners) * (reach_m * (0.05 + 0.95 * unit(random))));
  return ring;
}

TEST(Coverage, SumsToTheAreaOfTheRing) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double texel_m = 0.01 + 3 * unit(random) * unit(random);
    const Ring ring = random_star(random, {10 + 3 * unit(random), 12 * unit(random)}, 4);
    const auto rows = static_cast<std::uint32_t>(std::ceil(12 / texel_m));
    const Coverage cover = coverage_of(ring, texel_m, rows, {0, static_cast<std::uint32_t>(20 / texel_m) + 1});
    EXPECT_NEAR(sum_of(cover) * texel_m * texel_m, std::abs(signed_area_m2(ring)), 1e-9) << texel_m;
  }
}

TEST(Coverage, IsTheSameEitherWayRound) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    Ring ring = random_star(random, {5, 5}, 4);
    const Coverage there = coverage_of(ring, 0.3, 40, {0, 40});
    std::reverse(ring.begin(), ring.end());
    const Coverage back = coverage_of(ring, 0.3, 40, {0, 40});
    ASSERT_FALSE(there.share.empty());
    ASSERT_EQ(there.share.size(), back.share.size());
    for (std::size_t k = 0; k < there.share.size(); ++k) EXPECT_NEAR(there.share[k], back.share[k], 1e-12);
  }
}

TEST(Coverage, IsEachTexelsShare) {
  // a right triangle over two by two texels
  const Coverage cover = coverage_of({{0, 0}, {2, 0}, {0, 2}}, 1, 8, {0, 8});
  ASSERT_GE(cover.columns, 2u);
  EXPECT_EQ(cover.first_row, 0u);
  EXPECT_DOUBLE_EQ(cover.share[0], 1);
  EXPECT_DOUBLE_EQ(cover.share[1], 0.5);
  EXPECT_DOUBLE_EQ(cover.share[cover.columns], 0.5);
  EXPECT_DOUBLE_EQ(cover.share[cover.columns + 1], 0);
}

TEST(Coverage, IsClippedToItsColumns) {
  const Coverage cover = coverage_of({{-5, 0}, {20, 0}, {20, 1}, {-5, 1}}, 1, 4, {3, 7});
  EXPECT_EQ(cover.first_column, 3u);
  EXPECT_EQ(cover.columns, 4u);
  EXPECT_DOUBLE_EQ(sum_of(cover), 4);
}

TEST(Coverage, WrapsAlong) {
  const Coverage cover = coverage_of({{0, -0.25}, {1, -0.25}, {1, 0.5}, {0, 0.5}}, 1, 12, {0, 1});
  EXPECT_EQ(cover.first_row, 11u);
  ASSERT_EQ(cover.rows, 2u);
  EXPECT_DOUBLE_EQ(cover.share[0], 0.25);
  EXPECT_DOUBLE_EQ(cover.share[1], 0.5);
}

TEST(Coverage, IsNeverMoreThanOne) {
  // three times around the image
  const Coverage cover = coverage_of({{0, 0}, {1, 0}, {1, 37}, {0, 37}}, 1, 12, {0, 1});
  EXPECT_EQ(cover.rows, 12u);
  for (const double share : cover.share) EXPECT_DOUBLE_EQ(share, 1);
}

TEST(Coverage, IsEmptyForInvalidRings) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(coverage_of({}, 1, 4, {0, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{0, 0}, {1, 1}}, 1, 4, {0, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{0, 0}, {infinity, 0}, {0, 1}}, 1, 4, {0, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{0, 0}, {1e300, 0}, {0, 1}}, 1, 4, {0, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{0, 0}, {std::nan(""), 0}, {0, 1}}, 1, 4, {0, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{0, 0}, {1, 0}, {0, 1}}, 1, 4, {4, 4}).share.empty());
  EXPECT_TRUE(coverage_of({{9, 0}, {10, 0}, {9, 1}}, 1, 4, {0, 4}).share.empty());
}

}  // namespace
}  // namespace citykiln::materials
