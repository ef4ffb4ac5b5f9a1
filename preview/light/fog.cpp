#include "preview/light/fog.h"

#include <algorithm>
#include <cmath>

namespace citykiln::preview {
namespace {

constexpr double kContrast_log = 3.912;  // -ln 0.02
constexpr double kLevel = 1e-6, kFarthest_m = 1e6;

// The integral of density over height, from far below: height below the top, then what is above it.
double below(const Fog& fog, double z) {
  const double above = z - fog.top_m;
  return above < 0 ? above : fog.fade_m * (1 - std::exp(-above / fog.fade_m));
}

double density(const Fog& fog, double z) { return z < fog.top_m ? 1 : std::exp(-(z - fog.top_m) / fog.fade_m); }

}  // namespace

double fog_transmittance(const Fog& fog, Vec3 from, Vec3 direction, double distance_m) {
  const double way = std::min(distance_m, kFarthest_m), rise = direction.z * way;
  const double column_m = std::abs(direction.z) < kLevel
                              ? density(fog, from.z) * way
                              : (below(fog, from.z + rise) - below(fog, from.z)) / direction.z;
  return std::exp(-kContrast_log / fog.visibility_m * column_m);
}

}  // namespace citykiln::preview
