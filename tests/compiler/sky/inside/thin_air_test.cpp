#include "compiler/sky/inside/thin_air.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace citykiln::sky {
namespace {

Inside air_of(double fall, double radius_m = 1000) { return {.cylinder = {radius_m}, .fall = fall}; }

// Simpson's rule with many steps.
double by_simpson(const Inside& inside, Vec3 from, Vec3 direction, double distance_m) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i)
    sum += density_at(inside, from + direction * (distance_m * i / kSteps)) * (i == 0 || i == kSteps ? 1
                                                                               : i % 2               ? 4
                                                                                                     : 2);
  return sum * distance_m / kSteps / 3;
}

TEST(ThinAir, ColumnsAreThoseOfQuadrature) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const double fall : {0.05, kUsualFall, 5.0})
    for (int i = 0; i < 60; ++i) {
      const Inside inside = air_of(fall);
      const Vec3 from{share(random) * 3000, share(random) * 600, 1000 + share(random) * 600};
      const Vec3 direction = unit(Vec3{share(random), share(random), share(random)});
      double distance_m = 1400 * (1 + share(random));
      while (density_at(inside, from + direction * distance_m) > 1) distance_m *= 0.8;  // stays in the cylinder
      const double expected = by_simpson(inside, from, direction, distance_m);
      EXPECT_NEAR(column_m(inside, from, direction, distance_m), expected, 1e-8 * expected);
    }
}

TEST(ThinAir, AlongTheAxisColumnsAreLengths) {
  for (const double y : {0.0, 1e-9, 1e-7, 1e-5, 1e-3}) {
    const Vec3 direction = unit(Vec3{1, y, 0});
    EXPECT_NEAR(column_m(air_of(kUsualFall), {0, 0, 0}, direction, 5000),
                by_simpson(air_of(kUsualFall), {0, 0, 0}, direction, 5000), 1e-6);
  }
  EXPECT_NEAR(column_m(air_of(kUsualFall), {0, 0, 1000}, {1, 0, 0}, 100), 20, 1e-9);
}

TEST(ThinAir, AirAtTheGroundIsFiveTimesAsDenseAsAtTheAxis) {
  const Inside inside = air_of(kUsualFall, 8000);
  EXPECT_NEAR(density_at(inside, {0, 0, 0}), 1, 1e-12);
  EXPECT_NEAR(density_at(inside, {0, 0, 8000}), 0.2, 1e-12);
  // on the far side, on the ground again
  EXPECT_NEAR(density_at(inside, {0, 0, 16000}), 1, 1e-12);
}

}  // namespace
}  // namespace citykiln::sky
