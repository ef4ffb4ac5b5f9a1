// Road networks off the ground: bridges and tunnels, each with its own junctions.
//
//   ======+======  bridges, layer 1     Ways of one passage that share a node are one network, whatever layer=* they
//   ------+------  the ground           have: a deck cannot be at two heights at one node. Ways that cross without a
//   ......+......  tunnels, layer -1    shared node are in networks of different layers.
//
// Scenes do not hold these networks: bridges and tunnels are structures there. `inspect` counts and draws them.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// All ways of one passage (bridge or tunnel) and layer.
struct RoadLayer {
  int layer = 0;  ///< -10 to 10. Layers do not order heights: a bridge of layer -1 may cross a cutting.
  map::Passage passage{};
  std::vector<Road> roads;          ///< Sorted by id.
  std::vector<Junction> junctions;  ///< Result of plan_junctions().
  bool operator==(const RoadLayer&) const = default;
};

/// Sorts all tracks off the ground into layers, each track into exactly one. Layers are sorted by number, then passage;
/// none is empty.
///
/// The layer of a way is the lowest layer of all ways of its passage that are connected to it by shared nodes, so
/// distant ways can change it. A bridge without layer=* (or with 0) counts as 1, a tunnel as -1. Junctions depend on
/// nearby roads only. No junction contains an abutment or a tunnel portal: roads end there.
///
/// Junctions of one layer may lie above each other if a connected bridge passes over itself; outline_junctions() gives
/// the shared area to one of them. Ledger "roads/junction_off_ground": nodes in, junctions out, nodes that share a
/// junction merged. Diagnosed as by plan_junctions(). O(n log n) in vertices off the ground.
std::vector<RoadLayer> plan_layers(const map::FeatureView& features, Report& report);

}  // namespace citykiln::roads
