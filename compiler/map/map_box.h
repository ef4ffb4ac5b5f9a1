// Where a map lies: its own box, or that of its nodes without those that lie far away by mistake.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

struct StrayNode {
  std::int64_t id = 0;
  double away_deg = 0;  ///< From the map's box, the larger of both directions.
  auto operator<=>(const StrayNode&) const = default;
};

struct MapBox {
  source::LonLatBox box;
  std::vector<StrayNode> strays;  ///< Sorted by id; none for a map with a box in its header.
};

/// Returns the box in the extract's header; else that of the nodes of its buildings, or of its roads, without the
/// outermost 2 % in each direction, if these have 400 nodes or more; else that of all nodes of ways and nodes with
/// tags. Nodes of stray groups do not count. Total: zeros for an extract without nodes.
///
/// A group is what an empty margin of kGroupCell_deg or more separates from all other nodes; that is farther than
/// neighbouring nodes of ways lie apart anywhere but on ferries and power lines. A group is stray if it has less than 1
/// % of the nodes, or up to 8 nodes and less than a tenth of the largest group's: mistyped coordinates move single
/// nodes, while an island or a town has hundreds. O(n log n).
MapBox map_box(const source::OsmData& osm);

inline constexpr double kGroupCell_deg = 0.05;

}  // namespace citykiln::map
