// The contents of blocks of one use: parks, squares, schools, churches, cemeteries, sports grounds, allotments,
// supermarkets.
#pragma once

#include "compiler/invent/town/quarters.h"

namespace citykiln::invent {

/// Adds areas, buildings, paths and things of all blocks without lots. Paths begin at vertices of streets. Buildings
/// lie within the land of their block and in no water.
void add_block_contents(const TownPlan& plan, const std::vector<TownBlock>& blocks, InventedMap& map);

}  // namespace citykiln::invent
