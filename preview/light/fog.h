// Fog that fills valleys.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// A layer of fog, even below a height and exponentially thinner above it.
struct Fog {
  double top_m;               ///< Above sea level.
  double visibility_m = 300;  ///< Visibility in the layer: the distance at which 2 % of contrast remain.
  double fade_m = 25;         ///< Scale height above the top: density falls by a factor of e each so many metres.
};

/// The share of light that passes the fog along a ray, by the integral of its density.
/// @param from        z above sea level.
/// @param distance_m  May be infinite.
double passed_fog(const Fog& fog, Vec3 from, Vec3 direction, double distance_m);

}  // namespace citykiln::preview
