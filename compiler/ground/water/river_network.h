// The network of waterways: stations along them with the terrain's heights, joined at common vertices and lakes. A
// station is a place along a waterway at which a height is fitted; a node is one or several stations of equal height.
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

/// The error of a mapped line, as drawn from aerial pictures.
inline constexpr double kMappedError_m = 5;
/// A node whose height is to be found.
struct RiverNode {
  double land_m = 0;           ///< Height of the terrain; for standing water its level by the shore.
  double low_m = 0;            ///< The lowest terrain across the lines here within their lateral error; <= land_m.
  std::int64_t weight_mm = 1;  ///< Length of river that it represents; 1 if the terrain is unknown there.
  bool is_known() const { return weight_mm > 1; }
};

/// A place along a line.
struct RiverStation {
  double at_m = 0;  ///< Distance along the line.
  std::uint32_t node = 0;
  bool is_pinned = false;  ///< True at ends, junctions and shores: it becomes a knot. Others are at multiples of 1/8 m.
};

/// The stations of one waterway.
struct RiverLine {
  std::vector<RiverStation> stops;  ///< With strictly increasing at_m, from one end of the line to the other.
};

struct RiverNetwork {
  std::vector<RiverNode> nodes;  ///< Nodes of standing waters first, in their order.
  std::vector<RiverLine> lines;  ///< Lines of the streams, then of the covered axes.
  std::size_t water_count = 0;
  bool is_water(std::uint32_t node) const { return node < water_count; }
};

/// Builds the network. Lines meet at common vertices. Stations are half a grid step of the terrain apart, at least 8 m.
///
/// The lateral error of a line is kMappedError_m and half a grid step of the terrain: within it the floor of the valley
/// may lie beside the line.
///
/// @param covered   Axes of culverts and aqueducts, which connect rivers, directed downstream.
/// @param surfaces  Land cover, with the polygons of `waters`.
///
/// The order of lines decides only the numbers of nodes. O(n log n) in vertices and stations, plus streams times
/// waters.
RiverNetwork make_river_network(std::span<const roads::Strip> streams, std::span<const Polyline> covered,
                                std::span<const LandCoverPolygon> surfaces, const StandingWaters& waters,
                                const map::Heightfield& heights);

}  // namespace citykiln::ground
