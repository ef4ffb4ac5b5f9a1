// Waterways as a network: where they meet, where they run through standing water, and the land along them.
//
//   ~o~~o~~o~~o~~•~~o~~o~~[  lake  ]~~o~~o~~•      stops: o on the way, • where lines meet or end,
//                 \~o~~o~~/                        [ ] where one enters and leaves; a lake is one node
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/water/standing_water.h"
#include "compiler/map/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// A height to be found.
struct RiverNode {
  double land_m = 0;           ///< The heightfield's; of standing water its level by the shore.
  std::int64_t weight_mm = 1;  ///< Length of river that it stands for; 1 where the land says nothing of the water.
  bool is_known() const { return weight_mm > 1; }
};

struct RiverStation {
  double at_m = 0;  ///< Along the line.
  std::uint32_t node = 0;
  bool is_pinned =
      false;  ///< Where lines meet or end, and at shores: not to be thinned out. Others: a multiple of 1/8.
};

struct RiverLine {
  std::vector<RiverStation> stops;  ///< By at_m, strictly; from one end of the line to the other.
};

struct RiverNetwork {
  std::vector<RiverNode> nodes;  ///< Those of waters first, in their order.
  std::vector<RiverLine> lines;  ///< Of the streams, then of the covered ones.
  std::size_t water_count = 0;
  bool is_water(std::uint32_t node) const { return node < water_count; }
};

/// Lines meet where they have a vertex in common. Stops are half a step of the heightfield apart, at least 8 m.
///
/// @param covered  Axes of culverts and aqueducts, downstream like the streams': the water goes on through them.
/// Independent of order but for the numbers of nodes. O(n log n) in vertices and stops, plus streams times waters.
RiverNetwork make_river_network(std::span<const roads::Strip> streams, std::span<const Polyline> covered,
                                std::span<const LandCoverPolygon> surfaces, const StandingWaters& waters,
                                const map::Heightfield& heights);

}  // namespace citykiln::ground
