#include "compiler/materials/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace citykiln::materials {
namespace {

// The largest step between neighbours inside, and between the last and the first.
struct StepSizes {
  float inside = 0, round = 0;
};
StepSizes steps_of(const Field& field) {
  StepSizes steps;
  const std::uint32_t last = field.side_px - 1;
  for (std::uint32_t i = 0; i <= last; ++i) {
    for (std::uint32_t k = 0; k < last; ++k) {
      steps.inside = std::max(steps.inside, std::abs(field.at(k + 1, i) - field.at(k, i)));
      steps.inside = std::max(steps.inside, std::abs(field.at(i, k + 1) - field.at(i, k)));
    }
    steps.round = std::max(steps.round, std::abs(field.at(last, i) - field.at(0, i)));
    steps.round = std::max(steps.round, std::abs(field.at(i, last) - field.at(i, 0)));
  }
  return steps;
}

TEST(GradientNoise, RepeatsWithoutASeam) {
  for (std::uint64_t key = 0; key < 20; ++key) {
    const StepSizes steps = steps_of(gradient_noise(64, {8, 4}, key));
    EXPECT_GT(steps.inside, 0.01f);
    EXPECT_LE(steps.round, steps.inside * 1.2f);
  }
}

TEST(GradientNoise, HasAMeanNearZero) {
  for (std::uint64_t key = 0; key < 20; ++key) {
    double sum = 0;
    const Field field = gradient_noise(64, {16, 16}, key);
    ASSERT_EQ(field.values.size(), 64u * 64u);
    for (const float v : field.values) {
      sum += v;
      EXPECT_LT(std::abs(v), 1.5f);
    }
    EXPECT_NEAR(sum / static_cast<double>(field.values.size()), 0, 0.05);
  }
}

TEST(Cells, ContinueAcrossTheSquaresSides) {
  // a cell that crosses the side has the same number on both
  const Cells all = cells(128, 4, 3);
  int same = 0;
  for (std::uint32_t i = 0; i < 128; ++i) same += all.chance.at(127, i) == all.chance.at(0, i) ? 1 : 0;
  EXPECT_GT(same, 100);
}

TEST(NoiseOfThePlane, IsAFunctionOfThePlaceAlone) {
  for (double x = -5000; x < 5000; x += 173.25) EXPECT_EQ(noise_at({x, 3 * x}, 110, 7), noise_at({x, 3 * x}, 110, 7));
  EXPECT_NE(noise_at({100, 100}, 110, 7), noise_at({100, 100}, 110, 8));
}

TEST(NoiseOfThePlane, IsContinuousAndWithinOne) {
  double last = noise_at({-900, 11}, 35, 1), low = 0, high = 0;
  for (double x = -900; x < 900; x += 0.125) {
    const double v = noise_at({x, 11}, 35, 1);
    EXPECT_LE(std::abs(v), 1);
    // at most 15/8 of the whole range over a wave
    EXPECT_LE(std::abs(v - last), 2 * 1.875 * 0.125 / 35 + 1e-12);
    last = v, low = std::min(low, v), high = std::max(high, v);
  }
  EXPECT_LT(low, -0.5);
  EXPECT_GT(high, 0.5);
}

TEST(NoiseOfThePlane, IsZeroForInvalidPlaces) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300,
                        -1e12};
  for (const double x : bad) EXPECT_EQ(noise_at({x, 0}, 35, 1), 0);
}

}  // namespace
}  // namespace citykiln::materials
