// A place of the plane after it was mapped to a curved surface.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::map {

/// A place on or above a curved surface, and the directions of the plane's axes there.
struct BentPoint {
  Vec3 at;                 ///< The place, in the frame of the run.
  Vec3 east, north, up;    ///< The plane's x, y and z there: right-handed, unit length, in the frame of the run.
  double along_north = 1;  ///< The factor of lengths along north; those along east and up are nearly 1.
};

}  // namespace citykiln::map
