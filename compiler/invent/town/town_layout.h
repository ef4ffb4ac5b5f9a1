// The layout of a town: all that is decided before its houses and things.
#pragma once

#include "compiler/invent/town/blocks/town_lots.h"
#include "compiler/invent/town/quarters.h"
#include "compiler/invent/town/streets/street_edges.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

struct TownLayout {
  StreetGraph graph;
  std::vector<Vec2> roundabouts;  ///< Their middles.
  std::vector<Vec2> level_crossings;
  std::vector<StreetEdge> edges;
  std::vector<TownBlock> blocks;
  TownLots lots;
};

/// Lays out streets, blocks and lots of a plan.
TownLayout lay_out_town(const TownPlan& plan);

}  // namespace citykiln::invent
