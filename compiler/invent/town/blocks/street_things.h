// Things along streets: lamps, trees, crossings, signals, signs, bus stops and furniture.
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/streets/street_edges.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Adds the things. Crossings and signs are vertices of streets, which are added to the axes of edges.
void add_street_things(const TownPlan& plan, const StreetGraph& graph, std::vector<StreetEdge>& edges,
                       InventedMap& map);

}  // namespace citykiln::invent
