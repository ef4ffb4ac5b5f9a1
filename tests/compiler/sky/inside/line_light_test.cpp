#include "compiler/sky/inside/line_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "compiler/sky/inside/plan_inside.h"

namespace citykiln::sky {
namespace {

// Simpson's rule, halved until both halves agree.
double adaptive(const std::function<double(double)>& f, double a, double b, double least, int depth = 40) {
  const double m = (a + b) / 2, h = b - a;
  const auto simpson = [&](double x, double y) { return (y - x) / 6 * (f(x) + 4 * f((x + y) / 2) + f(y)); };
  const double whole = simpson(a, b), halves = simpson(a, m) + simpson(m, b);
  if (depth == 0 || std::abs(halves - whole) < 15 * least) return halves + (halves - whole) / 15;
  static_cast<void>(h);
  return adaptive(f, a, m, least / 2, depth - 1) + adaptive(f, m, b, least / 2, depth - 1);
}

// By the definition: pieces with an intensity of the sine of the angle with the line, by the square of the distance.
double by_quadrature(Vec3 from, Vec3 to, Vec3 place, const Vec3* normal) {
  const Vec3 along = unit(to - from);
  const auto piece = [&](double s) {
    const Vec3 out = from + along * s - place;
    const double distance2 = dot(out, out);
    const Vec3 direction = out * (1 / std::sqrt(distance2));
    const double sine = length(cross(direction, along));
    return sine * (normal != nullptr ? std::max(0.0, dot(*normal, direction)) : 1) / distance2;
  };
  double sum = 0;
  constexpr int kParts = 16;
  for (int i = 0; i < kParts; ++i)
    sum += adaptive(piece, length(to - from) * i / kParts, length(to - from) * (i + 1) / kParts, 1e-13);
  return sum;
}

struct Case {
  Vec3 from, to, place, normal;
};

std::vector<Case> random_cases(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  const auto point = [&](double size) {
    return Vec3{share(random) * size, share(random) * size, share(random) * size};
  };
  std::vector<Case> cases;
  while (static_cast<int>(cases.size()) < count) cases.push_back({point(50), point(50), point(20), unit(point(1))});
  return cases;
}

TEST(LineLight, IrradianceIsThatOfAdaptiveQuadrature) {
  int lit = 0, cut = 0;
  for (const auto& [from, to, place, normal] : random_cases(400)) {
    const auto whole = seen_line(from, to, place);
    const auto seen = seen_line(from, to, place, normal);
    ASSERT_TRUE(whole.has_value());
    const double found = seen ? irradiance(*seen, normal) : 0, expected = by_quadrature(from, to, place, &normal);
    EXPECT_NEAR(found, expected, 1e-6 * fluence(*whole)) << "expected " << expected;
    lit += found > 0;
    cut += seen && seen->extent() < 0.999 * whole->extent();
  }
  // lines above the horizon, across it and below it
  EXPECT_GT(cut, 50);
  EXPECT_GT(lit, 200);
  EXPECT_LT(lit, 390);
}

TEST(LineLight, FluenceIsThatOfAdaptiveQuadrature) {
  for (const auto& [from, to, place, normal] : random_cases(100))
    EXPECT_NEAR(fluence(*seen_line(from, to, place)), by_quadrature(from, to, place, nullptr), 1e-9);
}

TEST(LineLight, AnEndlessLineGivesAHalfPiOverItsDistance) {
  const auto seen = seen_line({-1e7, 0, 4}, {1e7, 0, 4}, {}, {0, 0, 1});
  EXPECT_NEAR(irradiance(*seen, {0, 0, 1}), std::numbers::pi / 2 / 4, 1e-12);
}

TEST(LineLight, AllFluxLeavesACylinderAroundTheLine) {
  // of a line of a kilometre, whose ends matter little
  const double radius_m = 2, around_m = 2 * std::numbers::pi * radius_m;
  const auto seen = seen_line({-500, 0, 0}, {500, 0, 0}, {0, radius_m, 0}, {0, -1, 0});
  EXPECT_NEAR(around_m * irradiance(*seen, {0, -1, 0}) * candela_per_m(1000), 1000, 0.02);
}

TEST(LineLight, DirectionsLeadToPointsOfTheLine) {
  const Vec3 from{-3, 1, 5}, to{9, 2, 4}, place{1, -1, 0};
  const auto seen = seen_line(from, to, place);
  for (const double share : {0.0, 0.25, 1.0}) {
    const double sine = seen->low_sine + share * seen->extent();
    const Vec3 at = place + direction_to(*seen, sine) * (seen->distance_m / std::sqrt(1 - sine * sine));
    EXPECT_LT(length(cross(at - from, unit(to - from))), 1e-9);
    EXPECT_NEAR(dot(at - from, unit(to - from)) / length(to - from), share, share > 0 && share < 1 ? 1 : 1e-9);
  }
}

TEST(PlannedInside, SixLinesGiveTheMiddleOfTheMapItsDaylightAndAreFarFromIt) {
  for (const double radius_m : {500.0, 978.0, 8000.0}) {
    const Inside inside = plan_inside({radius_m}, {{-1280, -1000}, {1280, 1000}});
    ASSERT_EQ(inside.lines.size(), 6u);
    EXPECT_NEAR(daylight_lx(inside, {0, 0, 0}), kInsideDaylight_lx, 1e-4 * kInsideDaylight_lx);
    for (const LineLight& line : inside.lines) {
      EXPECT_LT(line.from.x, line.to.x);
      EXPECT_GT(line.from.x, inside.west_m);
      EXPECT_LT(line.to.x, inside.east_m);
      EXPECT_GT(std::abs(line.from.y), radius_m);
    }
  }
}

}  // namespace
}  // namespace citykiln::sky
