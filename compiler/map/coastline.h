// Coastlines as lines become the sea as polygons. Water lies to the right of a coastline.
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

struct Sea {
  std::vector<Polygon> polygons;
  std::vector<OsmId>
      open_ends;  ///< Ways whose end lies inside the box and meets no other: led straight on to the box's side.
};

/// The sea inside a box.
///
/// Guarantees: outer rings counter-clockwise, islands as clockwise holes; a coast that enters and leaves the box is
/// closed along its sides with water on the right; without any coast that touches the box there is no sea. The product
/// does not depend on the order of the ways. Points on the box's sides are snapped. Bad input: coasts that cross each
/// other or run the wrong way give a wrong sea, but a product. O(n log n).
Sea close_sea(std::vector<CoastWay> ways, const Box2& box);

}  // namespace citykiln::map
