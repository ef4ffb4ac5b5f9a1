// Coefficients as in Bruneton, Neyret, "Precomputed Atmospheric Scattering", EGSR 2008, section 2, with the optical
// depths of spectrum.h.
#include "compiler/sky/atmosphere/air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/sky/spectrum.h"

namespace citykiln::sky {
namespace {

constexpr double kMoleculesHeight_m = 8000;
// The layer of ozone: a triangle about its middle.
constexpr double kOzoneMiddle_m = 25000, kOzoneHalfWidth_m = 15000;
// Share of extinction by aerosols that is absorption (Bruneton, Neyret 2008).
constexpr double kAbsorbed = 0.1;
constexpr double kVisibleContrast_log = 3.912;  // -ln 0.02
constexpr double kLowestAerosols_m = 500, kHighestAerosols_m = 8000;

}  // namespace

Air air_of(const Sky& sky) {
  const double molecules_per_m = molecules_depth(550) / kMoleculesHeight_m;
  const double aerosols_per_m = std::max(1e-7, kVisibleContrast_log / (sky.visibility_km * 1000) - molecules_per_m);
  const double height_m = aerosols_depth(550, sky.turbidity) / aerosols_per_m;
  return {.aerosols_550_per_m = aerosols_per_m,
          .aerosols_height_m = std::clamp(height_m, kLowestAerosols_m, kHighestAerosols_m),
          .ground_albedo = sky.ground_albedo};
}

Densities densities_at(const Air& air, double height_m) {
  const double h = std::max(height_m, 0.0);
  return {.molecules = std::exp(-h / kMoleculesHeight_m),
          .aerosols = std::exp(-h / air.aerosols_height_m),
          .ozone = std::max(0.0, 1 - std::abs(h - kOzoneMiddle_m) / kOzoneHalfWidth_m)};
}

Coefficients coefficients_at(const Air& air, double nm) {
  const double aerosols = air.aerosols_550_per_m * std::pow(nm / 550, -1.3);
  return {.molecules = molecules_depth(nm) / kMoleculesHeight_m,
          .aerosols = aerosols,
          .absorbed = aerosols * kAbsorbed,
          .ozone = ozone_depth(nm) / kOzoneHalfWidth_m};
}

double molecules_phase(double cosine) { return 3 / (16 * std::numbers::pi) * (1 + cosine * cosine); }

double aerosols_phase(double cosine) {
  constexpr double kSquared = kAsymmetry * kAsymmetry;
  const double base = 1 + kSquared - 2 * kAsymmetry * cosine;
  return (1 - kSquared) / (4 * std::numbers::pi * base * std::sqrt(base));
}

}  // namespace citykiln::sky
