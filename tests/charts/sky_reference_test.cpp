// The sky model against a spectral Monte Carlo integration that shares nothing with it but the description of air.
#include "tests/charts/sky_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/sky/generate.h"

namespace citykiln::charts {
namespace {

constexpr double kSunDegree = std::numbers::pi / 180;

sky::Sky clear_sky_at(double height_deg) {
  sky::Sky sky;
  sky.to_sun = {std::cos(height_deg * kSunDegree), 0, std::sin(height_deg * kSunDegree)};
  return sky;
}

// Chart `sky` measures the same over more directions and paths. The limits have room for the reference's noise.
TEST(SkyModel, IsNearASpectralIntegrationByDay) {
  for (const double height_deg : {60.0, 20.0, 5.0}) {
    const std::vector<double> errors = sky_errors(clear_sky_at(height_deg), 4, 3000, 0);
    ASSERT_EQ(errors.size(), 24u);
    EXPECT_LT(errors[12], 0.05) << height_deg;
    EXPECT_LT(errors[22], 0.15) << height_deg;
  }
}

TEST(SkyModel, IsNearASpectralIntegrationInTwilight) {
  const std::vector<double> errors = sky_errors(clear_sky_at(-3), 4, 3000, 0);
  EXPECT_LT(errors[12], 0.12);
  EXPECT_LT(errors[21], 0.40);
}

TEST(SkyModel, PassesLightThroughFiftyKilometresOfAirWithinTwoPercent) {
  for (const double visibility_km : {20.0, 100.0}) {
    sky::Sky sky = clear_sky_at(30);
    sky.visibility_km = visibility_km;
    for (const double height_m : {10.0, 1000.0}) {
      const sky::SkyModel model = sky::generate(sky, height_m);
      for (const double z : {-0.0002, 0.0, 0.02, 0.2})
        for (const double distance_m : {500.0, 5e3, 2e4, 5e4}) {
          const Vec3 direction = unit(Vec3{0.6, 0.8, z});
          const sky::Rgb wanted = reference_transmittance(air_of(sky), height_m, direction, distance_m);
          const sky::Rgb found = sky::air(model, direction, distance_m).passed;
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], wanted[c], 0.02 * wanted[c] + 5e-4) << height_m << " " << z << " " << distance_m;
        }
    }
  }
}

}  // namespace
}  // namespace citykiln::charts
