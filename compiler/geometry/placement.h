// The placement of an instanced mesh: a translation, a turn about the vertical and a uniform scale.
#pragma once

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

struct Placement {
  Vec3 at;                          ///< Place of the mesh's origin, plane metres, snapped.
  double cos_yaw = 1, sin_yaw = 0;  ///< Rotation about z, counter-clockwise seen from above.
  double scale = 1;
  OsmId feature;  ///< The map element that the instance belongs to.
};

}  // namespace citykiln
