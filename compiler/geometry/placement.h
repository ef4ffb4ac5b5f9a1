// Where a shared mesh stands: rigid but for one uniform scale, turned about the vertical only.
#pragma once

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

struct Placement {
  Vec3 at;                          ///< Plane metres, snapped: the mesh's origin comes here.
  double cos_yaw = 1, sin_yaw = 0;  ///< Turn about z, counter-clockwise from above.
  double scale = 1;
  OsmId feature;  ///< Whose it is.
};

}  // namespace citykiln
