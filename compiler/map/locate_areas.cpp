#include <algorithm>
#include <map>
#include <string>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/area_rules.h"
#include "compiler/map/bridge_areas.h"
#include "compiler/map/feature_readers.h"
#include "compiler/map/plant_tags.h"
#include "compiler/map/standing.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

const AreaRule* row_of(const ReadContext& context, source::Range tags) {
  return area_rule_of([&](std::string_view key) { return context.tag(tags, key); });
}

// A forest's class by its leaf type.
LandCoverClass with_leaves(LandCoverClass surface, LeafType leaves) {
  if (surface != LandCoverClass::kForest) return surface;
  if (leaves == LeafType::kBroad) return LandCoverClass::kBroadLeavedForest;
  if (leaves == LeafType::kNeedle) return LandCoverClass::kNeedleLeavedForest;
  return leaves == LeafType::kMixed ? LandCoverClass::kMixedForest : surface;
}

struct ValueClass {
  std::string_view value;
  LandCoverClass surface;
};
constexpr ValueClass kPitchSurfaces[] = {
#define SURFACE(value, class) {value, LandCoverClass::class},
#define SPORT(value, class)
#include "compiler/map/pitch_surfaces.inc"
#undef SURFACE
#undef SPORT
};
constexpr ValueClass kPitchSports[] = {
#define SURFACE(value, class)
#define SPORT(value, class) {value, LandCoverClass::class},
#include "compiler/map/pitch_surfaces.inc"
#undef SURFACE
#undef SPORT
};

// The class of a pitch by its surface, else by the first of its sports.
LandCoverClass pitch_class(std::string_view surface, std::string_view sports) {
  const auto of_surface = first_known(surface, [](std::string_view word) {
    const ValueClass* row = row_with(kPitchSurfaces, word);
    return row != nullptr ? std::optional(row->surface) : std::nullopt;
  });
  if (of_surface) return *of_surface;
  for (const ValueClass& row : kPitchSports)
    if (row.value == sports.substr(0, sports.find(';'))) return row.surface;
  return LandCoverClass::kPitch;
}

// The class after further tags.
LandCoverClass refined(const ReadContext& context, source::Range tags, LandCoverClass surface,
                       const PlantTags& plant_tags) {
  const std::string_view wetland = context.tag(tags, "wetland"), water = context.tag(tags, "water"),
                         sport = context.tag(tags, "sport");
  if (surface == LandCoverClass::kWetland && wetland == "marsh") return LandCoverClass::kMarsh;
  if (surface == LandCoverClass::kWetland && wetland == "reedbed") return LandCoverClass::kReedbed;
  if (surface == LandCoverClass::kLake && (water == "river" || water == "canal" || water == "stream"))
    return LandCoverClass::kRiver;
  if (surface == LandCoverClass::kPitch && context.tag(tags, "leisure") == "pitch")
    return pitch_class(context.tag(tags, "surface"), sport);
  return with_leaves(surface, plant_tags.leaves);
}

// The plant tags of areas where plants grow; elsewhere only spawners plant.
PlantTags growth_on(const ReadContext& context, const source::Area& area, LandCoverClass surface) {
  const LandCoverGroup group = values_of(surface).group;
  const bool is_green = group == LandCoverGroup::kForest || group == LandCoverGroup::kFarm ||
                        group == LandCoverGroup::kGarden || group == LandCoverGroup::kScrubland ||
                        group == LandCoverGroup::kGrassland || group == LandCoverGroup::kWetland;
  if (is_green) return read_plant_tags(context, area.from, area.tags);
  return {.spawner = tagged_spawner(context, area.tags)};
}

// The footprints of buildings with walls, and a grid to find them.
struct PoolObstacles {
  const std::vector<Footprint>& footprints;
  BoxGrid grid;
};

PoolObstacles pool_obstacles_of(const std::vector<Footprint>& footprints) {
  constexpr double kBucket_m = 64;
  std::vector<Box2> boxes;
  for (const Footprint& footprint : footprints) boxes.push_back(box_of(footprint.polygon.outer));
  return {footprints, grid_of(boxes, kBucket_m)};
}

// True if the first polygon of an area lies in a footprint.
bool is_pool_in_building(const std::vector<LocatedPolygon>& polygons, const PoolObstacles& buildings) {
  if (polygons.empty() || polygons.front().polygon.outer.empty() || buildings.footprints.empty()) return false;
  const Ring& ring = polygons.front().polygon.outer;
  return std::ranges::any_of(boxes_about(buildings.grid, ring.front()), [&](std::uint32_t i) {
    const Polygon& footprint = buildings.footprints[i].polygon;
    return !buildings.footprints[i].is_open &&
           std::ranges::all_of(ring, [&](Vec2 p) { return contains(footprint, p); });
  });
}

}  // namespace

bool is_closed_line(const ReadContext& context, source::Range tags, OsmType type) {
  if (type == OsmType::kRelation || says_yes(context.tag(tags, "area"))) return false;
  const bool road = !context.tag(tags, "highway").empty() && context.tag(tags, "highway") != "platform";
  const bool hedge = context.tag(tags, "barrier") == "hedge" && context.tag(tags, "landuse").empty();
  const std::string_view natural = context.tag(tags, "natural"), man_made = context.tag(tags, "man_made");
  const bool landform = natural == "cliff" || man_made == "dyke" || man_made == "embankment";
  return road || hedge || landform || context.tag(tags, "natural") == "coastline";
}

std::vector<AreaFeature> locate_areas(const ReadContext& context, const std::vector<Footprint>& footprints) {
  const PoolObstacles buildings = pool_obstacles_of(footprints);
  std::vector<AreaFeature> areas;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const AreaRule* row = row_of(context, area.tags);
    if (row == nullptr || row->surface == LandCoverClass::kUnknown ||
        is_closed_line(context, area.tags, area.from.type) || is_bridge_area(context, area))
      continue;
    account.in += context.report.counts(area.from);
    if (const auto reason = reason_to_drop(standing_of_area(context.osm, area.tags, row->key))) {
      context.report.drop(account, *reason, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(context, area);
    if (row->surface == LandCoverClass::kPool && is_pool_in_building(polygons, buildings)) {
      context.report.drop(account, Code::kInsideBuilding, area.from);
      continue;
    }
    PlantTags plant_tags = growth_on(context, area, row->surface);
    const LandCoverClass surface = refined(context, area.tags, row->surface, plant_tags);
    // a forest's class states its leaf type
    if (surface != row->surface && row->surface == LandCoverClass::kForest) plant_tags.leaves = LeafType::kUnknown;
    for_each_near_polygon(context, area.from, polygons, account, [&](const LocatedPolygon& polygon) {
      areas.push_back({.id = {area.from, polygon.part},
                       .polygon = polygon.polygon,
                       .surface = surface,
                       .area_m2 = polygon.area_m2,
                       .plant_tags = plant_tags});
    });
  }
  context.report.account("map", "area") = account;
  return areas;
}

std::vector<SportsArea> locate_sports_areas(const ReadContext& context, const std::vector<AreaFeature>& areas) {
  std::map<OsmId, std::string> sports;
  for (const source::Area& area : context.osm.areas)
    if (context.tag(area.tags, "leisure") == "pitch" && !context.tag(area.tags, "sport").empty())
      sports[area.from] = context.tag(area.tags, "sport");
  std::vector<SportsArea> found;
  for (const AreaFeature& area : areas)
    if (const auto sport = sports.find(area.id.osm); sport != sports.end()) found.push_back({area.id, sport->second});
  return found;
}

}  // namespace citykiln::map
