// The smallest rectangle about a ring.
#pragma once

#include "compiler/geometry/polygon.h"

namespace citykiln::parcels {

/// The smallest rectangle about a ring with a side along one of its edges.
struct TightBox {
  Vec2 centre, along;  ///< along: the direction of the longer sides, of length 1; {0, 0} for a ring without edges.
  double long_m = 0, short_m = 0;
};

/// Returns the smallest rectangle; of equally small ones that of the first edge. O(n²).
TightBox tight_box(const Ring& ring);

}  // namespace citykiln::parcels
