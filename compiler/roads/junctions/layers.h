// Networks off the ground: bridges and tunnels, apart from the ground and from each other, each with its junctions.
//
//   ======+======  bridges, layer 1     ways of one passage that share a node are one network, whatever their layer=*
//   ------+------  the ground           says: the deck cannot be at two heights there
//   ......+......  tunnels, layer -1    what crosses without a shared node is in networks of its own layer
//
// A network is in plan only: nothing of it is in a scene yet. Its decks and bores come with their heights, and until
// then a bridge is a structures::Span; compile() counts the junctions, `inspect --layer junctions` draws them.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// All ways of one passage and layer.
struct RoadLayer {
  int layer = 0;  ///< -10 to 10. Not the order of heights: a bridge of layer -1 crosses a cutting.
  map::Passage passage{};
  std::vector<Road> roads;          ///< Sorted by id.
  std::vector<Junction> junctions;  ///< As plan_junctions() leaves them.
  bool operator==(const RoadLayer&) const = default;
};

/// Every track off the ground in exactly one layer, none of the ground; sorted by layer, then passage; none is empty.
///
/// A bridge without layer=* (or with 0) is of layer 1, a tunnel of layer -1. Ways of one passage that share a node, and
/// those that share one with these, are of the lowest layer among them. So a layer's name hangs on all that a chain of
/// bridges reaches, however far; which ways a junction is made of hangs on plan_junctions()'s reach alone. Where a
/// bridge comes down on the ground both ends simply meet: no junction spans the abutment, nor a tunnel's mouth.
/// Junctions of one layer may still lie above each other, where a chain climbs over itself: outline() then gives what
/// they share to one of them, as on the ground.
/// Ledger "roads/junction_off_ground": places in, junctions out, places of one junction merged. Diagnosed: as
/// plan_junctions(). Total. O(n log n) in vertices off the ground.
std::vector<RoadLayer> plan_layers(const map::Features& features, Report& report);

}  // namespace citykiln::roads
