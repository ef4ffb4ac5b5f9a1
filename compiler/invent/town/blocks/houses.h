// Houses: what stands on the lots of a town.
//
//     core: closed rows about courtyards        houses: ▟▙ with a garage, sometimes a pair
//     ┌──┬──┬──┐   terraces: ▟▟▟▟ set back
//     │  ┌──┐  │   flats: long and square blocks on lawns
//     └──┴──┴──┘   industry: halls
#pragma once

#include "compiler/invent/town/blocks/town_lots.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Adds the buildings of all lots, their addresses, shops and gardens' things.
///
/// Guarantees: every footprint is simple, lies in its lot and so on no street and in no water; those of a lot are apart
/// or share a wall.
void add_houses(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                const std::vector<TownLot>& lots, InventedMap& map);

}  // namespace citykiln::invent
