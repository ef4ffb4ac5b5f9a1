// Fog that fills valleys.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// A layer of even fog below a height, which thins out exponentially above it.
struct Fog {
  double top_m;               ///< Above sea level.
  double visibility_m = 300;  ///< In the layer: 2 % of contrast remain.
  double fade_m = 25;         ///< Above the top, fog is thinner by e each so many metres.
};

/// The share of light that passes the fog along a ray.
/// @param from  z above sea level. @param distance_m  May be infinite. Source: integral of the layer's density.
double passed_fog(const Fog& fog, Vec3 from, Vec3 direction, double distance_m);

}  // namespace citykiln::preview
