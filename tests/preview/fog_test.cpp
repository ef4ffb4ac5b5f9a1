#include "preview/light/fog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace citykiln::preview {
namespace {

const Fog kFog{.top_m = 1000, .visibility_m = 300, .fade_m = 25};

// The density of the layer, in small steps.
double stepped(Vec3 from, Vec3 direction, double distance_m) {
  constexpr int kSteps = 100000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double z = from.z + direction.z * distance_m * (i + 0.5) / kSteps;
    sum += (z < kFog.top_m ? 1 : std::exp((kFog.top_m - z) / kFog.fade_m)) * distance_m / kSteps;
  }
  return std::exp(-3.912 / kFog.visibility_m * sum);
}

TEST(PassedFog, IsTheIntegralOfTheLayer) {
  for (const double z : {900.0, 999.0, 1010.0, 1100.0})
    for (const Vec3 direction :
         {Vec3{1, 0, 0}, unit(Vec3{1, 0, 0.1}), unit(Vec3{1, 0, -0.2}), Vec3{0, 0, 1}, Vec3{0, 0, -1}})
      for (const double distance_m : {1.0, 50.0, 400.0})
        EXPECT_NEAR(fog_transmittance(kFog, {0, 0, z}, direction, distance_m),
                    stepped({0, 0, z}, direction, distance_m), 1e-4);
}

TEST(PassedFog, HidesAllBelowTheTopAndNothingAboveIt) {
  EXPECT_NEAR(fog_transmittance(kFog, {0, 0, 900}, {1, 0, 0}, kFog.visibility_m), 0.02, 1e-3);
  EXPECT_GT(fog_transmittance(kFog, {0, 0, 1300}, {1, 0, 0}, 10000), 0.99);
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_LT(fog_transmittance(kFog, {0, 0, 1300}, unit(Vec3{1, 0, -0.2}), endless), 1e-6);
  EXPECT_GT(fog_transmittance(kFog, {0, 0, 1300}, unit(Vec3{1, 0, 0.2}), endless), 0.99);
}

}  // namespace
}  // namespace citykiln::preview
