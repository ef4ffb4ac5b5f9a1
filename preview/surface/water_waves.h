// Waves of water, which are visible only in reflections.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// The waves in the footprint of a pixel: the part of the surface that it covers.
struct Waves {
  Vec3 normal{0, 0, 1};     ///< Unit normal of the waves that are longer than the footprint.
  double slope_spread = 0;  ///< Variance, in one direction, of the slope of all shorter waves.
};

/// Returns the waves at a place of the plane, in metres. They depend on the place alone, and are smooth. The total
/// variance is the same for any footprint.
/// @param footprint_m  Length of the part of the surface that a pixel covers. > 0.
Waves waves_at(Vec2 place, double footprint_m);

}  // namespace citykiln::preview
