// Finds the box of a map: the box in its header, else the box of its nodes without stray nodes, which lie far away by
// mistake.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// A node that does not count for the box.
struct StrayNode {
  std::int64_t id = 0;
  double away_deg = 0;  ///< Distance from the map's box in longitude or latitude, whichever is larger.
  auto operator<=>(const StrayNode&) const = default;
};

/// The box of a map, in degrees.
struct MapBox {
  source::LonLatBox box;
  std::vector<StrayNode> strays;  ///< Sorted by id; none for a map with a box in its header.
};

/// Returns the box in the extract's header. Without one, it returns the box of the nodes of buildings, else of roads,
/// without the outermost 1 % on each of the four sides, if there are 400 nodes or more; else of all nodes of ways and
/// all nodes with tags. Nodes of stray groups do not count. An extract without nodes gives zeros.
///
/// A group is a set of nodes with an empty margin of kGroupCell_deg or more around it. Neighbouring nodes of a way are
/// nearer to each other, except on ferries and power lines. A group is stray if it has less than 1 % of the nodes, or
/// up to 8 nodes and less than a tenth of the largest group's: mistyped coordinates move single nodes, while an island
/// or a town has hundreds. O(n log n).
MapBox map_box(const source::OsmData& osm);

/// The width of the empty margin around a group.
inline constexpr double kGroupCell_deg = 0.05;

}  // namespace citykiln::map
