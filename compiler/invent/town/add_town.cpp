#include "compiler/invent/town/add_town.h"

#include "compiler/geometry/trig.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/blocks/block_contents.h"
#include "compiler/invent/town/blocks/houses.h"
#include "compiler/invent/town/blocks/street_things.h"
#include "compiler/invent/town/railway.h"
#include "compiler/invent/town/streets/roundabouts.h"
#include "compiler/invent/town/streets/street_sections.h"
#include "compiler/invent/town/town_layout.h"

namespace citykiln::invent {
namespace {

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
  TownLayout layout = lay_out_town(plan);
  add_street_things(plan, layout.graph, layout.edges, map);
  add_streets(plan, layout.graph, layout.edges, map);
  add_railway(plan, layout.level_crossings, map);
  add_islands(layout.roundabouts, map);
  for (InventedArea& land : layout.lots.land) map.areas.push_back(std::move(land));
  add_block_contents(plan, layout.blocks, map);
  add_houses(plan, layout.graph, layout.edges, layout.lots.lots, map);
}

}  // namespace citykiln::invent
