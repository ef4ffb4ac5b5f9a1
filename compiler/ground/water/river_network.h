// The network of waterways: stations along them with the terrain's heights, joined at common vertices and lakes. A
// station is a place along a waterway at which a height is fitted; a node is one or several stations of equal height.
// The height profile of a waterway (river_profile.h) is linear between points that are called knots.
//
//   ~o~~o~~o~~o~~•~~o~~o~~[  lake  ]~~o~~o~~•      stations: o on the way, • where lines meet or end,
//                 \~o~~o~~/                        [ ] where one enters and leaves; a lake is one node
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/water/standing_water.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// A node whose height is to be found.
struct RiverNode {
  double land_m = 0;           ///< Height of the terrain; for standing water its level by the shore.
  std::int64_t weight_mm = 1;  ///< Length of river that it represents; 1 if the terrain is unknown there.
  bool is_known() const { return weight_mm > 1; }
};

/// A place along a line.
struct RiverStation {
  double at_m = 0;  ///< Distance along the line.
  std::uint32_t node = 0;
  /// True at ends, junctions and shores, where the profile must have a knot. Knots at other stations, whose at_m are
  /// multiples of 1/8 m, may be omitted.
  bool is_pinned = false;
};

/// The stations of one waterway.
struct RiverLine {
  std::vector<RiverStation> stops;  ///< With strictly increasing at_m, from the start of the axis to its end.
};

struct RiverNetwork {
  std::vector<RiverNode> nodes;  ///< Nodes of standing waters first, in their order.
  std::vector<RiverLine> lines;  ///< Lines of the streams, then of the covered axes.
  std::size_t water_count = 0;
  bool is_water(std::uint32_t node) const { return node < water_count; }
};

/// Builds the network. Lines meet at common vertices. A line has stations at its ends, where it meets other lines and
/// at shores, and between these at most half a grid step of the terrain apart, or 8 m if that is more. There are no
/// further stations inside a lake or on a covered axis.
///
/// @param streams   Watercourses. Their axes count as directed downstream, as those of `covered` do;
///                  plan_water_heights() reverses axes that are mapped uphill and builds the network again.
/// @param covered   Axes of culverts and aqueducts, which connect rivers, directed downstream.
/// @param surfaces  Land cover, with the polygons of `waters`: as many as waters.water_of has entries (asserted).
///
/// Cannot fail. The order of lines decides only the numbers of nodes. O(n log n) in vertices and stations, plus streams
/// times waters.
RiverNetwork make_river_network(std::span<const roads::Strip> streams, std::span<const Polyline> covered,
                                std::span<const LandCoverPolygon> surfaces, const StandingWaters& waters,
                                const map::Heightfield& heights);

}  // namespace citykiln::ground
