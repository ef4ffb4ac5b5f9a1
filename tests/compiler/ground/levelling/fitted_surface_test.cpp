#include "compiler/ground/levelling/fitted_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compiler/contract/random_sequence.h"

namespace citykiln::ground {
namespace {

template <typename Height>
std::vector<Vec3> points_on(Height height_m, double half_m = 50) {
  std::vector<Vec3> points;
  for (double y = -half_m; y <= half_m; y += half_m / 8)
    for (double x = -half_m; x <= half_m; x += half_m / 8) points.push_back({3000 + x, -2000 + y, height_m(x, y)});
  return points;
}

TEST(FittedSurface, ReproducesPlanesAndBentSurfaces) {
  const auto plane = points_on([](double x, double y) { return 700 + 0.01 * x - 0.02 * y; });
  for (const Vec3& p : plane)
    EXPECT_NEAR(fitted_surface(plane, SurfaceForm::kPlane, 1).height_m({p.x, p.y}), p.z, 1e-6);
  const auto bent = points_on([](double x, double y) { return 5 + 1e-4 * x * x - 2e-4 * x * y + 0.01 * y; });
  for (const Vec3& p : bent) EXPECT_NEAR(fitted_surface(bent, SurfaceForm::kBent, 1).height_m({p.x, p.y}), p.z, 1e-6);
}

TEST(FittedSurface, IsNotMovedByAQuarterOfWrongPoints) {
  const RandomSequence draw(1, StableId{1}, "wrong");
  std::uint32_t next = 0;
  const auto points = points_on([&](double x, double) {
    const double noise_m = draw.between(-0.1, 0.1, next++);
    return 10 + 0.005 * x + noise_m + (draw.between(0, 1, next++) < 0.25 ? 20 : 0);
  });
  const FittedSurface plane = fitted_surface(points, SurfaceForm::kPlane, 1);
  for (const double x : {-50.0, 0.0, 50.0}) EXPECT_NEAR(plane.height_m({3000 + x, -2000}), 10 + 0.005 * x, 0.15);
}

TEST(FittedSurface, IsNoSteeperThanAllowed) {
  const auto hill = points_on([](double x, double y) { return 0.3 * x + 0.01 * y * y; });
  for (const SurfaceForm form : {SurfaceForm::kPlane, SurfaceForm::kBent}) {
    const FittedSurface surface = fitted_surface(hill, form, 0.01);
    for (const Vec3& p : hill) EXPECT_LE(length(surface.gradient({p.x, p.y})), 0.01 + 1e-12);
  }
}

TEST(FittedSurface, IsLevelWithoutPointsAndThroughASinglePoint) {
  EXPECT_EQ(fitted_surface({}, SurfaceForm::kPlane, 1).height_m({5, 5}), 0);
  const Vec3 one{5, 6, 7};
  EXPECT_NEAR(fitted_surface(std::span(&one, 1), SurfaceForm::kBent, 1).height_m({50, 60}), 7, 1e-9);
}

}  // namespace
}  // namespace citykiln::ground
