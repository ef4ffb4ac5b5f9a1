#include "compiler/invent/town/town_layout.h"

#include "compiler/invent/town/railway.h"
#include "compiler/invent/town/streets/grow_streets.h"
#include "compiler/invent/town/streets/main_roads.h"
#include "compiler/invent/town/streets/roundabouts.h"
#include "compiler/invent/town/town_names.h"

namespace citykiln::invent {
namespace {

/// From the axis of a street to the land of parks and the like beside it: half a street and its pavement.
constexpr double kLandInset_m = 6.5;

}  // namespace

TownLayout lay_out_town(const TownPlan& plan) {
  TownLayout layout{main_roads(plan), {}, {}, {}, {}, {}};
  layout.level_crossings = cross_railway(plan, layout.graph);
  layout.roundabouts = make_roundabouts(plan, layout.graph);
  grow_streets(plan, street_field(plan, layout.graph), layout.graph);
  join_station(plan, layout.graph);
  keep_largest_part(layout.graph);
  name_streets(plan, layout.graph);
  layout.edges = street_edges(layout.graph);
  const StreetBlocks blocks = street_blocks(layout.graph, layout.edges);
  layout.blocks = plan_quarters(plan, blocks, kLandInset_m);
  layout.lots = divide_town(plan, layout.graph, layout.edges, layout.blocks);
  return layout;
}

}  // namespace citykiln::invent
