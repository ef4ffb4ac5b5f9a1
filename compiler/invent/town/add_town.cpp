#include "compiler/invent/town/add_town.h"

#include "compiler/geometry/trig.h"
#include "compiler/invent/town/block_contents.h"
#include "compiler/invent/town/grow_streets.h"
#include "compiler/invent/town/houses.h"
#include "compiler/invent/town/main_roads.h"
#include "compiler/invent/town/quarters.h"
#include "compiler/invent/town/roundabouts.h"
#include "compiler/invent/town/street_edges.h"
#include "compiler/invent/town/street_sections.h"
#include "compiler/invent/town/street_things.h"
#include "compiler/invent/town/tags.h"
#include "compiler/invent/town/town_lots.h"
#include "compiler/invent/town/town_names.h"

namespace citykiln::invent {
namespace {

/// From the axis of a street to the land of parks and the like beside it: half a street and its pavement.
constexpr double kLandInset_m = 6.5;

void add_streets(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                 InventedMap& map) {
  for (const StreetEdge& edge : edges)
    map.lines.push_back({edge.axis, street_tags(plan, edge, graph.streets[edge.street])});
}

// the middle of a roundabout: grass and a tree
void add_islands(const std::vector<Vec2>& middles, InventedMap& map) {
  for (const Vec2 middle : middles) {
    Ring ring;
    for (int i = 0; i < 16; ++i) ring.push_back(on_place_grid(middle + direction_of(i / 16.0) * (kRoundabout_m - 4)));
    map.areas.push_back({{ring, {}}, tags_of({{"landuse", "grass"}})});
    map.points.push_back({on_place_grid(middle), tags_of({{"natural", "tree"}, {"leaf_type", "broadleaved"}})});
  }
}

}  // namespace

void add_town(const Terrain& terrain, const TownSettings& settings, InventedMap& map) {
  const TownPlan plan = plan_town(terrain, settings);
  StreetGraph graph = main_roads(plan);
  const std::vector<Vec2> roundabouts = make_roundabouts(plan, graph);
  grow_streets(plan, street_field(plan, graph), graph);
  keep_largest_part(graph);
  name_streets(plan, graph);
  std::vector<StreetEdge> edges = street_edges(graph);
  const StreetBlocks blocks = street_blocks(graph, edges);
  const std::vector<TownBlock> quarters = plan_quarters(plan, blocks, kLandInset_m);
  TownLots lots = divide_town(plan, graph, edges, quarters);
  add_street_things(plan, graph, edges, map);
  add_streets(plan, graph, edges, map);
  add_islands(roundabouts, map);
  for (InventedArea& land : lots.land) map.areas.push_back(std::move(land));
  add_block_contents(plan, quarters, map);
  add_houses(plan, graph, edges, lots.lots, map);
}

}  // namespace citykiln::invent
