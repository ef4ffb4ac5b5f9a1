#include "compiler/map/plane/cylinder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace citykiln::map {
namespace {

TEST(Cylinder, PointsAreThoseOfTheFormula) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const double radius_m : {100.0, 977.848, 8000.0, 1e6})
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p{share(random) * 1e5, share(random) * std::numbers::pi * radius_m, share(random) * 0.9 * radius_m};
      const Vec3 found = at({radius_m}, p).at;
      const double turn = p.y / radius_m;
      EXPECT_EQ(found.x, p.x);
      EXPECT_NEAR(found.y, (radius_m - p.z) * std::sin(turn), 1e-12 * radius_m);
      EXPECT_NEAR(found.z, radius_m - (radius_m - p.z) * std::cos(turn), 1e-12 * radius_m);
    }
}

TEST(Cylinder, AStripAsLongAsTheCircumferenceClosesOnItself) {
  for (const double radius_m : {100.0, 977.848, 1e6}) {
    const Cylinder cylinder{radius_m};
    const double around_m = circumference_m(cylinder);
    for (const double y : {-around_m / 2, 0.0, 12.5, around_m / 3}) {
      const BentPoint here = at(cylinder, {5, y, 30}), there = at(cylinder, {5, y + around_m, 30});
      EXPECT_LT(length(here.at - there.at), 2e-12 * radius_m);
      EXPECT_LT(length(here.up - there.up), 1e-14);
    }
  }
}

TEST(Cylinder, AxesAreTheDirectionsInWhichPointsMove) {
  const Cylinder cylinder{500};
  constexpr double kStep_m = 1e-4;
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{3, 400, 20}, Vec3{-9, -1500, -40}, Vec3{1, 785, 450}}) {
    const BentPoint here = at(cylinder, p);
    const auto moved = [&](Vec3 by) { return (at(cylinder, p + by).at - at(cylinder, p - by).at) * (0.5 / kStep_m); };
    EXPECT_LT(length(moved({kStep_m, 0, 0}) - here.east), 1e-8);
    EXPECT_LT(length(moved({0, kStep_m, 0}) - here.north * here.along_north), 1e-8);
    EXPECT_LT(length(moved({0, 0, kStep_m}) - here.up), 1e-8);
    EXPECT_LT(length(cross(here.east, here.north) - here.up), 1e-12);
    EXPECT_NEAR(here.along_north, 1 - p.z / 500, 1e-12);
  }
}

TEST(Cylinder, FlattenedIsTheInverse) {
  const Cylinder cylinder{977.848};
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{300, 3000, 46}, Vec3{-12, -2900, -3}, Vec3{7, 5000, 900}})
    EXPECT_LT(length(flattened(cylinder, at(cylinder, p).at, p.y + 2000) - p), 1e-9);
}

// Points of straight edges and triangles against the images of the plane's ones, corners at random.
TEST(Cylinder, SagBoundsTheDistanceFromTheBentSurface) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit_share(0, 1);
  const Cylinder cylinder{300};
  double closest = 0;
  for (int i = 0; i < 3000; ++i) {
    Vec3 corners[3];
    double low_y = 1e9, high_y = -1e9, low_z = 1e9, high_z = -1e9;
    for (Vec3& c : corners) {
      c = {unit_share(random) * 100, unit_share(random) * 80, unit_share(random) * 120 - 60};
      low_y = std::min(low_y, c.y), high_y = std::max(high_y, c.y);
      low_z = std::min(low_z, c.z), high_z = std::max(high_z, c.z);
    }
    const double bound_m = sag_m(cylinder, high_y - low_y, high_z - low_z, stretch(cylinder, low_z));
    double a = unit_share(random), b = unit_share(random);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const auto mixed = [&](const auto& of) {
      return of(corners[0]) * a + of(corners[1]) * b + of(corners[2]) * (1 - a - b);
    };
    const Vec3 plane = mixed([](Vec3 p) { return p; }), flat = mixed([&](Vec3 p) { return at(cylinder, p).at; });
    const double off_m = length(at(cylinder, plane).at - flat);
    EXPECT_LE(off_m, bound_m);
    closest = std::max(closest, off_m / bound_m);
  }
  // the bound is not far from what occurs
  EXPECT_GT(closest, 0.6);
}

}  // namespace
}  // namespace citykiln::map
