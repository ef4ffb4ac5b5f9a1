// Roundabouts where main roads meet outside of centres.
#pragma once

#include "compiler/invent/town/streets/street_graph.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// The radius of a roundabout's axis, metres.
inline constexpr double kRoundabout_m = 15;

/// Replaces some junctions of main roads in the graph by circles, counter-clockwise, and returns the middles of these,
/// in metres from the middle of the town. A junction stays as it is if its arms are too close to each other or meet
/// others within the circle.
std::vector<Vec2> make_roundabouts(const TownPlan& plan, StreetGraph& graph);

}  // namespace citykiln::invent
