#include "compiler/geometry/trig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln {
namespace {

TEST(DirectionOf, IsWithin5e16OfTheTrueOne) {
  double worst = 0;
  for (int i = -20000; i <= 20000; ++i) {
    const double turns = i / 8192.0 + i * 1e-7;
    const long double angle = 2 * std::numbers::pi_v<long double> * turns;
    const Vec2 d = direction_of(turns);
    worst = std::max(worst, static_cast<double>(std::fabs(d.x - std::cos(angle))));
    worst = std::max(worst, static_cast<double>(std::fabs(d.y - std::sin(angle))));
  }
  EXPECT_LT(worst, 5e-16);
}

TEST(DirectionOf, HasLengthOne) {
  for (int i = 0; i < 1000; ++i) EXPECT_NEAR(length(direction_of(i / 1000.0)), 1, 5e-16);
}

TEST(DirectionOf, IsExactAtQuarterTurns) {
  EXPECT_EQ(direction_of(0), (Vec2{1, 0}));
  EXPECT_EQ(direction_of(0.25), (Vec2{0, 1}));
  EXPECT_EQ(direction_of(0.5), (Vec2{-1, 0}));
  EXPECT_EQ(direction_of(-0.25), (Vec2{0, -1}));
  EXPECT_EQ(direction_of(7), (Vec2{1, 0}));
}

}  // namespace
}  // namespace citykiln
