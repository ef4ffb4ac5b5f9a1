#include "compiler/geometry/mathematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace citykiln {
namespace {

struct Mathematics : testing::Test {
  std::mt19937 chance{3};
  double between(double low, double high) { return low + (high - low) * static_cast<double>(chance()) / 4294967296.0; }
};

constexpr double kDegree = 0.017453292519943295;

TEST_F(Mathematics, AnglesAgreeWithLibmToFourteenDigits) {
  for (int i = 0; i < 20'000; ++i) {
    const double a = between(-720, 720), x = between(-1, 1), y = between(-50, 50);
    ASSERT_NEAR(sine(a), std::sin(a * kDegree), 1e-14);
    ASSERT_NEAR(cosine(a), std::cos(a * kDegree), 1e-14);
    ASSERT_NEAR(arcsine_deg(x), std::asin(x) / kDegree, 1e-12);
    ASSERT_NEAR(arccosine_deg(x), std::acos(x) / kDegree, 1e-12);
    ASSERT_NEAR(arctangent2_deg(y, x), std::atan2(y, x) / kDegree, 1e-13);
  }
}

TEST_F(Mathematics, PowersAgreeWithLibmToThirteenDigits) {
  for (int i = 0; i < 20'000; ++i) {
    const double base = between(0.01, 100), exponent = between(-20, 20), x = between(-600, 600);
    ASSERT_NEAR(power(base, exponent) / std::pow(base, exponent), 1, 1e-13);
    ASSERT_NEAR(exponential(x) / std::exp(x), 1, 1e-13);
    ASSERT_NEAR(logarithm(base), std::log(base), 1e-14);
  }
}

TEST_F(Mathematics, QuartersAndWholePowersAreExact) {
  EXPECT_EQ(sine(90), 1);
  EXPECT_EQ(cosine(90), 0);
  EXPECT_EQ(arctangent2_deg(1, 0), 90);
  EXPECT_EQ(arctangent2_deg(0, -1), 180);
  EXPECT_EQ(arctangent2_deg(0, 0), 0);
  EXPECT_EQ(power(3, 4), 81);
  EXPECT_EQ(power(-2, 3), -8);
  EXPECT_EQ(power(2, -2), 0.25);
}

TEST_F(Mathematics, IsFiniteOutsideTheDomain) {
  for (const double value : {arcsine_deg(2), logarithm(-1), logarithm(0), power(-1, 0.5), power(0, -1), power(1e300, 9),
                             exponential(1e6), tangent(90)})
    EXPECT_TRUE(std::isfinite(value)) << value;
}

}  // namespace
}  // namespace citykiln
