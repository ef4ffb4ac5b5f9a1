// Scattering that can be computed by hand: white surfaces under even light, and samples against their density.
#include "preview/surface/bsdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace citykiln::preview {
namespace {

SurfacePoint surface(double albedo, float roughness, float metallic, Vec3 normal = {0, 0, 1}) {
  SurfacePoint hit;
  hit.geometric_normal = hit.shading_normal = unit(normal);
  hit.albedo = {albedo, albedo, albedo};
  hit.roughness = roughness, hit.metallic = metallic;
  return hit;
}

Vec3 at_angle(double degrees, double turn = 0.1) {
  const double a = degrees * std::numbers::pi / 180;
  return {std::sin(a) * std::cos(2 * std::numbers::pi * turn), std::sin(a) * std::sin(2 * std::numbers::pi * turn),
          std::cos(a)};
}

// The light towards the eye under even light of 1, by the sampled directions.
double furnace(const SurfacePoint& hit, Vec3 to_eye) {
  constexpr int kSide = 400;
  const Bsdf bsdf(hit, to_eye, 0);
  const PixelSamples pixel(7, 0, 0, grid_of(1, 1, kSide * kSide));
  double sum = 0;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    PathDraw draw(pixel, i);
    const double lobe = draw.next().u;
    sum += bsdf.sample(lobe, draw.next()).weight[1];
  }
  return sum / (kSide * kSide);
}

TEST(Bsdf, WhiteMattSurfacesAreAsBrightAsEvenLight) {
  for (const float roughness : {0.0f, 0.2f, 0.5f, 0.9f, 1.0f})
    for (const double angle : {0.0, 30.0, 60.0, 80.0})
      EXPECT_NEAR(furnace(surface(1, roughness, 0), at_angle(angle)), 1, roughness == 0.5f ? 0.002 : 0.001)
          << roughness << " " << angle;
}

TEST(Bsdf, WhiteMetalsAreAsBrightAsEvenLight) {
  for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f})
    for (const double angle : {0.0, 45.0, 75.0})
      EXPECT_NEAR(furnace(surface(1, roughness, 1), at_angle(angle)), 1, 0.01) << roughness << " " << angle;
}

TEST(Bsdf, LeavesShareTheirLightBetweenBothSides) {
  SurfacePoint leaf = surface(0.5, 1, 0);
  leaf.translucency = 1;
  EXPECT_NEAR(furnace(leaf, at_angle(40)), 1, 1e-6);
}

TEST(Bsdf, ScatteringIsReciprocal) {
  for (const float roughness : {0.15f, 0.4f, 0.9f})
    for (const float metallic : {0.0f, 0.5f, 1.0f})
      for (const double a : {5.0, 50.0, 75.0})
        for (const double b : {20.0, 65.0}) {
          const SurfacePoint hit = surface(0.6, roughness, metallic);
          const Vec3 one = at_angle(a, 0.2), other = at_angle(b, 0.55);
          const double there = Bsdf(hit, one, 0).scattering(other).light[1] / other.z;
          const double back = Bsdf(hit, other, 0).scattering(one).light[1] / one.z;
          EXPECT_NEAR(there, back, 1e-9 + 1e-6 * back) << roughness << " " << metallic << " " << a << " " << b;
        }
}

// Pearson's statistic of samples in cells of equal solid angle against the integral of the density over each.
double chi_squared(const Bsdf& bsdf, int samples, int& cells) {
  constexpr int kRows = 20, kColumns = 20, kFine = 24;
  std::vector<double> expected(kRows * kColumns), found(kRows * kColumns);
  const auto cell_of = [&](Vec3 d) {
    double turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi);
    if (turn < 0) turn += 1;
    const int row = std::clamp(static_cast<int>((d.z + 1) / 2 * kRows), 0, kRows - 1);
    return row * kColumns + std::min(static_cast<int>(turn * kColumns), kColumns - 1);
  };
  for (int row = 0; row < kRows * kFine; ++row)
    for (int column = 0; column < kColumns * kFine; ++column) {
      const double z = -1 + 2 * (row + 0.5) / (kRows * kFine), r = std::sqrt(1 - z * z);
      const double turn = 2 * std::numbers::pi * (column + 0.5) / (kColumns * kFine);
      const Vec3 d{r * std::cos(turn), r * std::sin(turn), z};
      expected[cell_of(d)] +=
          bsdf.scattering(d).pdf * 4 * std::numbers::pi / (kRows * kFine * kColumns * kFine) * samples;
    }
  const PixelSamples pixel(3, 5, 9, {0, 0});
  for (int i = 0; i < samples; ++i) {
    // independent points, which the statistic assumes
    const PixelSamples own(static_cast<std::uint64_t>(i), 0, 0, {0, 0});
    const BsdfSample drawn = bsdf.sample(own.pair(0, 30).u, own.pair(0, 31));
    if (drawn.pdf > 0) ++found[cell_of(drawn.direction)];
  }
  double sum = 0, rest_expected = 0, rest_found = 0;
  cells = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (expected[i] < 5) {
      rest_expected += expected[i], rest_found += found[i];
      continue;
    }
    sum += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
    ++cells;
  }
  if (rest_expected > 5) sum += (rest_found - rest_expected) * (rest_found - rest_expected) / rest_expected, ++cells;
  return sum;
}

TEST(Bsdf, SamplesFollowTheirDensity) {
  SurfacePoint leaf = surface(0.4, 1, 0);
  leaf.translucency = 0.7;
  SurfacePoint bent = surface(0.5, 0.5f, 0);
  bent.shading_normal = unit(Vec3{0.4, 0.1, 1});
  const std::vector<SurfacePoint> surfaces = {surface(0.5, 0.5f, 0), surface(0.8, 0.6f, 1), surface(0.3, 1, 0.5f), leaf,
                                              bent};
  for (const SurfacePoint& point : surfaces)
    for (const double angle : {10.0, 70.0}) {
      int cells = 0;
      const double chi2 = chi_squared(Bsdf(point, at_angle(angle), 0), 200000, cells);
      ASSERT_GT(cells, 20);
      // Wilson and Hilferty's approximation of the 99.9 % quantile
      const double n = cells - 1, limit = n * std::pow(1 - 2 / (9 * n) + 3.09 * std::sqrt(2 / (9 * n)), 3);
      EXPECT_LT(chi2, limit) << point.roughness << " " << angle << " of " << cells;
    }
}

}  // namespace
}  // namespace citykiln::preview
