// Coastlines come in pieces, one a way. Here they are joined, end to start, into chains that lead from one side of the region to another or
// around an island.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// One coastline, a way or several joined. The sea lies on its right.
struct Coast {
  OsmId named_by;  ///< Its way with the lowest id.
  Polyline axis;   ///< Plane metres, snapped, no repeated neighbours, at least two points. Closed: the last point is not repeated, at least three.
  bool is_closed = false;
};

/// Joins coastlines where one ends at the place where another begins; where several begin there, the one with the lowest id goes on.
///
/// Guarantees: every edge of every way is in exactly one chain; what comes out does not depend on the order of `ways`. Chains are sorted by named_by.
/// O(n log n), n = ways.
std::vector<Coast> joined(std::vector<Coast> ways);

/// Closes gaps: every chain that ends inside the box goes on, straight, to the nearest of the chains that begin inside it or to the nearest place
/// on the box's rim; what then still begins inside comes from the rim. Each is diagnosed kCoastlineOpen with the metres that were added.
///
/// Guarantees: no open chain ends inside the box. Nearest first, then by id. O(k² log k) for k ends inside, but with more than 1000 they all go to the rim.
std::vector<Coast> with_gaps_closed(std::vector<Coast> chains, const Box2& box, Report& report);

}  // namespace citykiln::map
