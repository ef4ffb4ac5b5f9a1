// The limits within which lines are lowered: by pinned nodes, which keep their heights, and by the depth of cuttings.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/graph_walk.h"

namespace citykiln::ground {

/// A pinned node limits heights of other nodes up to this height above its own.
inline constexpr double kPinRadius_m = 64;

/// Returns for each node the greatest height that the grade limits allow from the pinned nodes near it; infinity if
/// none is near.
/// @param z_m  Heights by node.
std::vector<double> caps_near_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m);

/// The largest depth below its terrain to which a line on the ground may be lowered, as under a railway, with slopes on
/// both sides.
inline constexpr double kMaxCutting_m = 8;
/// The largest lowering of a street on the ground for the sake of an access road, such as the ramp of a garage.
inline constexpr double kMaxCuttingForAccess_m = 2.5;

/// True for service roads, farm tracks and unpaved roads. Streets are hardly lowered for them (kMaxCuttingForAccess_m).
bool is_access_road(map::LandCoverClass surface);

/// The lowest allowed heights by node, with changed sign.
struct LoweringCaps {
  std::vector<double> of_access, of_others;  ///< For lowering with an access road, and with any other line.
};

/// Returns the lowest allowed heights. Lines on the ground may be kMaxCutting_m below `ground_m`; streets that are
/// lowered with an access road kMaxCuttingForAccess_m. Tunnels, and access roads connected to such streets, may go
/// lower at their grade limits. Near pinned nodes grade limits apply, too. Radius of influence: kPinRadius_m of height.
/// @param ground_m  Heights by node before any lowering.
LoweringCaps lowering_caps(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> ground_m);

}  // namespace citykiln::ground
