// Makes polygons of the sea from coastlines, which are lines with water on their right.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// One natural=coastline way.
struct CoastWay {
  OsmId id;
  Polyline axis;  ///< Plane metres.
  std::int64_t first_node = 0, last_node = 0;
};

/// The sea inside a box.
struct Sea {
  std::vector<Polygon> polygons;
  /// Coastline ways with an end inside the box that no other way continues. Such an end is extended straight to a side.
  std::vector<OsmId> open_ends;
};

/// Returns the sea inside a box.
///
/// Guarantees: outer rings counter-clockwise, islands as clockwise holes; a coast that enters and leaves the box is
/// closed along its sides with water on the right; without a coast that touches the box there is no sea. The order of
/// ways does not matter. Points on the box's sides are snapped. Coasts that cross each other or have water on the left
/// give a wrong sea. O(n log n + p² + islands · vertices of the sea), n: ways, p: parts of coasts between sides of the
/// box.
Sea close_sea(std::vector<CoastWay> ways, const Box2& box);

}  // namespace citykiln::map
