// From coastlines to the sea: what lies on their right, closed along the region's rim.
//
//   +-----------+   1. chains are cut at the rim; a piece enters (E) and exits (X)
//   |    land   |   2. from E the rim is followed counter-clockwise to the next X: sea lies between
//   E~~~~~~~~~~~X   3. pieces walked backwards and these stretches of rim are the sea's outer rings
//   |  sea  (o) |   4. closed chains inside are islands (counter-clockwise) or seas of their own (clockwise)
//   +-----------+
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/map/coast_chains.h"

namespace citykiln::map {

/// One connected sea of the region.
struct Sea {
  OsmId named_by;  ///< The coastline of its outer ring with the lowest id; type kNone where the whole rim lies in the sea.
  Polygon polygon;
};

/// The seas of a box.
///
/// @param chains  Without ends inside the box (with_gaps_closed). Chains outside the box matter only where none crosses its rim: then the nearest one
///                says whether the rim lies in the sea.
/// @param box     Not empty; corners on the plane's grid.
/// Guarantees: within the box; points on the plane's grid; where coastlines do not cross each other, the seas are disjoint and every point of the box to the
/// right of its nearest coastline is in one. Sorted by named_by, then by place. Without chains there is no sea.
/// Total: coastlines that contradict each other along the rim are paired like brackets; islands on land have no effect.
/// O(n + p log p + i s), n points, p pieces, i islands, s points of the seas around them.
std::vector<Sea> seas_of(std::span<const Coast> chains, const Box2& box);

}  // namespace citykiln::map
