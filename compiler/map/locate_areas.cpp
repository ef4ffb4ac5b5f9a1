#include "compiler/map/area_rules.h"
#include "compiler/map/feature_readers.h"
#include "compiler/map/plant_tags.h"
#include "compiler/map/standing.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

const AreaRule* row_of(const ReadContext& context, source::Range tags) {
  for (const AreaRule& row : area_rules()) {
    const std::string_view value = context.tag(tags, row.key);
    if (row.value == "*" ? says_yes(value) : value == row.value) return &row;
  }
  return nullptr;
}

// True for closed ways that are lines by their tags (a road, a hedge, a coast) unless area=yes.
bool is_line(const ReadContext& context, source::Range tags, OsmType type) {
  if (type == OsmType::kRelation || says_yes(context.tag(tags, "area"))) return false;
  const bool road = !context.tag(tags, "highway").empty() && context.tag(tags, "highway") != "platform";
  const bool hedge = context.tag(tags, "barrier") == "hedge" && context.tag(tags, "landuse").empty();
  const std::string_view natural = context.tag(tags, "natural"), man_made = context.tag(tags, "man_made");
  const bool landform = natural == "cliff" || man_made == "dyke" || man_made == "embankment";
  return road || hedge || landform || context.tag(tags, "natural") == "coastline";
}

// A forest's class by its leaf type.
LandCoverClass with_leaves(LandCoverClass surface, LeafType leaves) {
  if (surface != LandCoverClass::kForest) return surface;
  if (leaves == LeafType::kBroad) return LandCoverClass::kBroadLeavedForest;
  if (leaves == LeafType::kNeedle) return LandCoverClass::kNeedleLeavedForest;
  return leaves == LeafType::kMixed ? LandCoverClass::kMixedForest : surface;
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
  if (surface == LandCoverClass::kPitch && (sport == "tennis" || sport == "basketball" || sport == "skateboard"))
    return LandCoverClass::kHardCourt;
  return with_leaves(surface, plant_tags.leaves);
}

// The plant tags of areas where plants grow.
PlantTags growth_on(const ReadContext& context, const source::Area& area, LandCoverClass surface) {
  const LandCoverGroup group = values_of(surface).group;
  const bool is_green = group == LandCoverGroup::kForest || group == LandCoverGroup::kFarm ||
                        group == LandCoverGroup::kGarden || group == LandCoverGroup::kScrubland ||
                        group == LandCoverGroup::kGrassland || group == LandCoverGroup::kWetland;
  return is_green ? read_plant_tags(context, area.from, area.tags) : PlantTags{};
}

}  // namespace

std::vector<AreaFeature> locate_areas(const ReadContext& context) {
  std::vector<AreaFeature> areas;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const AreaRule* row = row_of(context, area.tags);
    if (row == nullptr || row->surface == LandCoverClass::kUnknown || is_line(context, area.tags, area.from.type))
      continue;
    account.in += context.report.counts(area.from);
    if (const auto reason = reason_to_drop(standing_of_area(context.osm, area.tags, row->key))) {
      context.report.drop(account, *reason, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(context, area);
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

}  // namespace citykiln::map
