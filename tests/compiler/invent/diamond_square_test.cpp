#include "compiler/invent/land/diamond_square.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::invent {
namespace {

TEST(DiamondSquare, CornersHaveTheInitialHeight) {
  const DiamondSquare settings{.power = 5, .initial_height_m = 12.5, .spread_m = 40, .reduction = 0.6};
  const std::vector<double> heights = diamond_square(settings, 3);
  ASSERT_EQ(heights.size(), 33U * 33U);
  for (const std::size_t corner : {std::size_t{0}, std::size_t{32}, std::size_t{32 * 33}, std::size_t{33 * 33 - 1}})
    EXPECT_EQ(heights[corner], 12.5);
}

TEST(DiamondSquare, CornersAreDrawnWithinTheirSpread) {
  const DiamondSquare settings{
      .power = 3, .initial_height_m = 2, .corner_spread_m = 5, .spread_m = 40, .reduction = 0.6};
  double low = 1e9, high = -1e9;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<double> heights = diamond_square(settings, seed);
    for (const std::size_t corner : {std::size_t{0}, std::size_t{8}, std::size_t{8 * 9}, std::size_t{9 * 9 - 1}}) {
      low = std::min(low, heights[corner]);
      high = std::max(high, heights[corner]);
    }
  }
  EXPECT_GE(low, -3);
  EXPECT_LT(low, -2) << "200 corners leave the lower tenth empty";
  EXPECT_LE(high, 7);
  EXPECT_GT(high, 6);
}

TEST(DiamondSquare, HeightsLieWithinTwiceTheSumOfSpreads) {
  const DiamondSquare settings{.power = 7, .initial_height_m = 100, .spread_m = 10, .reduction = 0.5};
  // 10 + 5 + 2.5 + … over seven levels
  const double most_m = 2 * 10 * (1 - 1.0 / 128) / 0.5;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<double> heights = diamond_square(settings, seed);
    const auto [low, high] = std::ranges::minmax(heights);
    EXPECT_GE(low, 100 - most_m);
    EXPECT_LE(high, 100 + most_m);
    EXPECT_GT(high - low, 10) << "the land is flat";
  }
}

TEST(DiamondSquare, WithoutSpreadTheLandIsLevel) {
  for (const double height : diamond_square({.power = 4, .initial_height_m = 7, .spread_m = 0, .reduction = 0.5}, 1))
    EXPECT_EQ(height, 7);
}

TEST(DiamondSquare, SeedsDiffer) {
  const DiamondSquare settings{.power = 4, .initial_height_m = 0, .spread_m = 10, .reduction = 0.5};
  EXPECT_EQ(diamond_square(settings, 1), diamond_square(settings, 1));
  EXPECT_NE(diamond_square(settings, 1), diamond_square(settings, 2));
}

}  // namespace
}  // namespace citykiln::invent
