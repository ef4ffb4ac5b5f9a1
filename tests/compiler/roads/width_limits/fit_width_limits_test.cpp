#include "compiler/roads/width_limits/fit_width_limits.h"

#include <gtest/gtest.h>

#include <random>

#include "compiler/roads/width_limits/building_obstacles.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

constexpr int kWhole = 200;

// A random limit; half the time constant or slowly changing, as along walls.
std::vector<std::int16_t> made_limit(std::mt19937_64& dice, std::size_t size) {
  std::vector<std::int16_t> limit;
  int at = static_cast<int>(dice() % (kWhole + 20)), step = 0;
  while (limit.size() < size) {
    if (dice() % 20 == 0) step = static_cast<int>(dice() % 3) - 1;
    at = std::clamp(at + (dice() % 4 == 0 ? step : 0) + (dice() % 3 == 0 ? 0 : step) - (dice() % 9 == 0), at - 1,
                    at + 1);
    at = std::clamp(at, 10, kWhole + 20);
    limit.push_back(static_cast<std::int16_t>(at));
  }
  return limit;
}

double half_at(const std::vector<WidthLimit>& width_limits, std::int32_t step) {
  Road road = made_road(1, {{0, 0}, {10, 0}}, 2 * kWhole * kUnit_m);
  road.width_limits.left = width_limits;
  return std::min(max_offsets_at(road, step * kStep_m).left_m / kUnit_m, double{kWhole});
}

TEST(FitWidthLimits, StayCloseBelowTheSampledLimit) {
  std::mt19937_64 dice(7);
  for (int run = 0; run < 200; ++run) {
    const std::vector<std::int16_t> limit = made_limit(dice, 1 + dice() % 900);
    const auto first = static_cast<std::int32_t>(dice() % 1000);
    const std::vector<WidthLimit> width_limits = fit_width_limits(limit, kWhole, first);
    for (std::size_t i = 0; i < limit.size(); ++i) {
      const double wanted = std::min<int>(limit[i], kWhole);
      const double said = half_at(width_limits, first + static_cast<std::int32_t>(i));
      ASSERT_LE(said, wanted + 1e-9) << run << " " << i;
      ASSERT_GE(said, wanted - kSlack_units - 1e-9) << run << " " << i;
      if (i == 0 || i + 1 == limit.size()) {
        ASSERT_NEAR(said, wanted, 1e-9);
      }
    }
  }
}

TEST(FitWidthLimits, AreNoneWithoutALimit) {
  EXPECT_TRUE(fit_width_limits(std::vector<std::int16_t>(999, kWhole), kWhole, 0).empty());
  EXPECT_TRUE(fit_width_limits(std::vector<std::int16_t>(), kWhole, 0).empty());
}

TEST(FitWidthLimits, AreOneForACornerAndTwoForAWall) {
  std::vector<std::int16_t> corner, wall;
  for (int i = -60; i <= 60; ++i) corner.push_back(static_cast<std::int16_t>(std::min(kWhole, 150 + std::abs(i))));
  for (int i = -60; i <= 60; ++i)
    wall.push_back(static_cast<std::int16_t>(std::min(kWhole, 170 + std::max(0, std::abs(i) - 20))));
  EXPECT_EQ(fit_width_limits(corner, kWhole, 0), (std::vector<WidthLimit>{{15, 150 * kUnit_m, false}}));
  EXPECT_EQ(fit_width_limits(wall, kWhole, 0),
            (std::vector<WidthLimit>{{10, 170 * kUnit_m, false}, {20, 170 * kUnit_m, true}}));
}

TEST(FitWidthLimits, DependOnTheirOwnBlockAlone) {
  // along a curving wall each line begins where the previous one ends
  for (int head = 0; head < 40; ++head) {
    std::vector<std::int16_t> limit;
    for (int i = 0; i < 1500; ++i) limit.push_back(static_cast<std::int16_t>(190 - (i - 750) * (i - 750) / 4000));
    const std::vector<WidthLimit> before = fit_width_limits(limit, kWhole, 0);
    for (int i = 0; i < 10 + 5 * head; ++i) limit[static_cast<std::size_t>(i)] = kWhole;
    for (std::size_t i = limit.size() - 1; i > 0; --i)
      limit[i - 1] = std::min(limit[i - 1], static_cast<std::int16_t>(limit[i] + 1));
    const std::vector<WidthLimit> after = fit_width_limits(limit, kWhole, 0);
    for (std::int32_t step = kBlock_steps; step < 1500; ++step)
      ASSERT_DOUBLE_EQ(half_at(before, step), half_at(after, step)) << head << " " << step;
  }
}

}  // namespace
}  // namespace citykiln::roads
