#include "compiler/sky/air_settings.h"

#include <algorithm>
#include <cassert>

namespace citykiln::sky {
namespace {

// At sea level and 550 nm, as atmosphere/air.h has them.
constexpr double kMolecules_per_m = 1.2517e-5, kAngstrom = 2.1754, kScaleHeight_m = 6000, kContrast_log = 3.912;

double visibility_km_of(double turbidity) {
  const double aerosols_per_m = std::max(0.0, 0.04608 * turbidity - 0.04586) * kAngstrom / kScaleHeight_m;
  return std::clamp(kContrast_log / (kMolecules_per_m + aerosols_per_m) / 1000, kHaziest_km, kClearest_km);
}

}  // namespace

void set_air(const AirSettings& settings, Sky& sky) {
  if (settings.turbidity) sky.turbidity = *settings.turbidity, sky.visibility_km = visibility_km_of(sky.turbidity);
  if (settings.visibility_km) sky.visibility_km = *settings.visibility_km;
  if (settings.ground_albedo) sky.ground_albedo = *settings.ground_albedo;
  assert(sky.turbidity >= kLeastTurbidity && sky.turbidity <= kMostTurbidity);
  assert(sky.visibility_km >= kHaziest_km && sky.visibility_km <= kClearest_km);
}

}  // namespace citykiln::sky
