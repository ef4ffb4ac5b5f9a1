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

// Chromaticities of CIE 15, by IEC 61966-2-1.
TEST(BlackBodyColour, IsThatOfThePlanckianLocus) {
  const struct {
    double kelvin, x, y;
  } kKnown[] = {{2000, 0.5267, 0.4133}, {3000, 0.4369, 0.4041}, {4000, 0.3805, 0.3768}, {6500, 0.3135, 0.3237}};
  for (const auto& [kelvin, x, y] : kKnown) {
    const auto [r, g, b] = black_body_colour(kelvin);
    const double X = 0.4124 * r + 0.3576 * g + 0.1805 * b, Y = 0.2126 * r + 0.7152 * g + 0.0722 * b,
                 Z = 0.0193 * r + 0.1192 * g + 0.9505 * b;
    EXPECT_NEAR(X / (X + Y + Z), x, 0.002) << kelvin;
    EXPECT_NEAR(Y / (X + Y + Z), y, 0.002) << kelvin;
  }
  for (double kelvin = 1000; kelvin < 20000; kelvin += 250) {
    const auto [r, g, b] = black_body_colour(kelvin);
    EXPECT_NEAR(0.2126 * r + 0.7152 * g + 0.0722 * b, 1, 1e-5);
    EXPECT_TRUE(r >= 0 && g >= 0 && b >= 0);
  }
  EXPECT_GT(black_body_colour(2000)[0] / black_body_colour(2000)[2], 8);
}

}  // namespace
}  // namespace citykiln::props
