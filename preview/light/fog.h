// Fog that fills valleys.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// A layer of fog: of constant density below a height, and exponentially thinner above it.
struct Fog {
  double top_m;               ///< Height above sea level up to which the density is constant.
  double visibility_m = 300;  ///< Visibility in the layer: the distance at which 2 % of contrast remain.
  double fade_m = 25;  ///< Scale height above top_m: the height in which the density falls by a factor of e. Metres.
};

/// Returns the share of light that passes the fog along a ray, 0 to 1: exp of minus the density's integral.
/// @param from        Plane metres; z above sea level.
/// @param direction   Unit.
/// @param distance_m  The length of the ray. May be infinite.
double fog_transmittance(const Fog& fog, Vec3 from, Vec3 direction, double distance_m);

}  // namespace citykiln::preview
