#include "compiler/props/luminaire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln::props {
namespace {

using map::LampMount;
using map::LampType;

TEST(Luminaire, FollowsTagsThenTypeThenHeight) {
  EXPECT_EQ(luminaire_of(LampKind::kArm, 10), (Luminaire{10000, 4000, Beam::kDown}));
  EXPECT_EQ(luminaire_of(LampKind::kPostTop, 4), (Luminaire{2500, 3000, Beam::kLantern}));
  EXPECT_EQ(luminaire_of(LampKind::kArm, 10, {.type = LampType::kHighPressureSodium}),
            (Luminaire{10000, 2000, Beam::kDown}));
  EXPECT_EQ(luminaire_of(LampKind::kPostTop, 4, {.type = LampType::kGas}), (Luminaire{1000, 2700, Beam::kLantern}));
  EXPECT_EQ(luminaire_of(LampKind::kPostTop, 4, {.type = LampType::kGas, .temperature_k = 2500, .lumen = 600}),
            (Luminaire{600, 2500, Beam::kLantern}));
  EXPECT_EQ(luminaire_of(LampKind::kArm, 8, {.count = 2}).lumen, 2 * luminaire_of(LampKind::kArm, 8).lumen);
  EXPECT_EQ(luminaire_of(LampKind::kPostTop, 6, {.mount = LampMount::kWall}).beam, Beam::kDown);
  EXPECT_EQ(kind_of(LampMount::kBentMast, LampKind::kPostTop), LampKind::kArm);
  EXPECT_EQ(kind_of(LampMount::kWall, LampKind::kPostTop), LampKind::kPostTop);
}

// By integration over directions.
TEST(Luminaire, BeamsHaveTheSolidAngleOfTheirShape) {
  double down = 0, lantern = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -1 + 2 * (i + 0.5) / kSteps, band_sr = 4 * std::numbers::pi / kSteps;
    down += std::max(0.0, -z) * band_sr, lantern += z < kLanternRise ? band_sr : 0;
  }
  EXPECT_NEAR(beam_sr(Beam::kDown), down, 1e-3);
  EXPECT_NEAR(beam_sr(Beam::kLantern), lantern, 1e-3);
}

// Against integrals of Planck's law with the CIE 1931 observer.
TEST(BlackBodyColour, IsThatOfThePlanckianLocus) {
  const struct {
    double kelvin;
    std::array<double, 3> rgb;
  } kKnown[] = {{3000, {1.770, 0.839, 0.326}}, {4000, {1.424, 0.918, 0.556}}};
  for (const auto& [kelvin, rgb] : kKnown)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(black_body_colour(kelvin)[c], rgb[c], 0.03) << kelvin;
  for (double kelvin = 1000; kelvin < 20000; kelvin += 250) {
    const auto [r, g, b] = black_body_colour(kelvin);
    EXPECT_NEAR(0.2126 * r + 0.7152 * g + 0.0722 * b, 1, 1e-5);
    EXPECT_TRUE(r >= 0 && g >= 0 && b >= 0);
  }
  EXPECT_GT(black_body_colour(2000)[0] / black_body_colour(2000)[2], 8);
}

}  // namespace
}  // namespace citykiln::props
