// Waves: small enough to be seen by how they mirror alone.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// A wavy surface as one pixel sees it.
struct Waves {
  Vec3 normal{0, 0, 1};     ///< Unit; of the waves that are wide enough to be told apart.
  double slope_spread = 0;  ///< Variance of the slope, in one direction, of all finer waves.
};

/// Of a place in the plane, in metres: the same sea from wherever it is seen. `footprint_m` is how much of it a pixel
/// covers. Smooth; the whole variance stays the same at any footprint.
Waves waves_at(Vec2 place, double footprint_m);

}  // namespace citykiln::preview
