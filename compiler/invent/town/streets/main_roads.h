// Main roads: from the centres to the border of the world, and between centres.
#pragma once

#include "compiler/invent/town/streets/street_graph.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Returns the graph of main roads. It is connected. Bridges are single segments. Roads end on the border of the
/// square.
StreetGraph main_roads(const TownPlan& plan);

}  // namespace citykiln::invent
