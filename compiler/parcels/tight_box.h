// The smallest rectangle around a ring, in any direction.
#pragma once

#include "compiler/geometry/polygon.h"

namespace citykiln::parcels {

/// A rectangle around a ring, with a side along one of its edges: its centre in plane metres, and
/// its sides.
struct TightBox {
  Vec2 centre, along;  ///< along: the unit vector of the longer sides.
  double long_m = 0, short_m = 0;
};

/// Returns the rectangle with the smallest area that contains all points of a ring. The first edge
/// counts among equal areas. All members are 0 for a ring without edges. O(n²).
TightBox tight_box(const Ring& ring);

}  // namespace citykiln::parcels
