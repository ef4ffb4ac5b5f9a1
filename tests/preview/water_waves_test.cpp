#include "preview/surface/water_waves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::preview {
namespace {

// The sums of squares of the slopes to the east and to the north of the waves that are seen, over a square of 400 m.
Vec2 seen_variance(const Footprint& footprint) {
  Vec2 sum;
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const Vec3 n = waves_at({std::fmod(i * 7.31, 400), std::fmod(i * 3.77, 397)}, footprint).normal;
    sum = sum + Vec2{n.x * n.x, n.y * n.y} * (1 / (n.z * n.z) / kPlaces);
  }
  return sum;
}

double total_variance(const Footprint& footprint) {
  const Vec2 seen = seen_variance(footprint);
  return (seen.x + seen.y) / 2 + waves_at({3, 5}, footprint).slope_spread;
}

TEST(WaterWaves, WhatIsBelowAPixelBecomesRoughnessOfTheSameVariance) {
  const double all = total_variance({.along_m = 0.001, .across_m = 0.001});
  for (const double length_m : {0.1, 0.5, 2.0, 30.0})
    EXPECT_NEAR(total_variance({.along_m = length_m, .across_m = length_m}), all, 0.04 * all) << length_m;
}

TEST(WaterWaves, FromFarAboveTheWaterIsSmooth) {
  // less than two pixels for the longest wave of 17 m
  EXPECT_EQ(waves_at({100, 50}, {.along_m = 9, .across_m = 9}).normal, (Vec3{0, 0, 1}));
}

TEST(WaterWaves, AtGrazingAnglesThoseAlongTheViewVanishFirst) {
  const Vec2 grazing = seen_variance({.along = {1, 0}, .along_m = 5, .across_m = 0.05});
  const Vec2 square = seen_variance({.along_m = 0.05, .across_m = 0.05});
  EXPECT_GT(grazing.y / grazing.x, 2 * square.y / square.x);
}

TEST(WaterWaves, AreFlatterOnShortWater) {
  const Footprint fine{.along_m = 0.001, .across_m = 0.001};
  const Vec3 at_sea = waves_at({12, 34}, fine, 1).normal, on_pond = waves_at({12, 34}, fine, 0.25).normal;
  EXPECT_NEAR(on_pond.x / on_pond.z, at_sea.x / at_sea.z / 4, 1e-9);
  EXPECT_NEAR(waves_at({}, {.along_m = 99, .across_m = 99}, 0.25).slope_spread * 16,
              waves_at({}, {.along_m = 99, .across_m = 99}).slope_spread, 1e-9);
  using enum materials::Material;
  EXPECT_GT(wave_strength(kSea), wave_strength(kWater));
  EXPECT_GT(wave_strength(kWater), wave_strength(kRiverWater));
  EXPECT_GT(wave_strength(kRiverWater), wave_strength(kShallowWater));
}

}  // namespace
}  // namespace citykiln::preview
