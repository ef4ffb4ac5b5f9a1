// Waves of water, which are visible only in reflections.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// The waves in the footprint of a pixel: the part of the surface that it covers.
struct Waves {
  Vec3 normal{0, 0, 1};     ///< Unit normal of the waves that are longer than the footprint.
  double slope_spread = 0;  ///< Variance, in one direction, of the slope of all shorter waves.
};

/// The part of the surface that a pixel covers, in plan.
struct Footprint {
  Vec2 along{1, 0};                  ///< Unit; the direction of view.
  double along_m = 1, across_m = 1;  ///< Lengths along it and across. > 0.
};

/// Returns the waves at a place of the plane, in metres. They depend on the place alone, and are smooth. The total
/// variance is the same for any footprint. A wave is seen if a pixel is shorter than a part of it in the wave's
/// direction: at grazing angles, waves along the view vanish before those across it.
Waves waves_at(Vec2 place, const Footprint& footprint);

}  // namespace citykiln::preview
