#include <array>

#include "compiler/map/locate_parts.h"
#include "compiler/map/plant_tags.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

struct AreaRow {
  std::string_view key, value;
  SurfaceClass surface;
};

constexpr AreaRow kAreas[] = {
#define AREA(key, value, surface) {key, value, SurfaceClass::surface},
#include "compiler/map/area_rules.inc"
#undef AREA
};

constexpr std::array<std::string_view, 9> kLandKeys = {"landuse",  "natural", "leisure", "waterway", "amenity",
                                                       "man_made", "aeroway", "golf",    "place"};

const AreaRow* row_of(const Reading& reading, source::Range tags) {
  for (const AreaRow& row : kAreas) {
    const std::string_view value = reading.tag(tags, row.key);
    if (row.value == "*" ? says_yes(value) : value == row.value) return &row;
  }
  return nullptr;
}

bool carries_land_key(const Reading& reading, source::Range tags) {
  for (const std::string_view key : kLandKeys)
    if (!reading.tag(tags, key).empty()) return true;
  return false;
}

// A closed way with a line's meaning (a road, a hedge, a stream) is an area only where it says so.
bool is_line(const Reading& reading, source::Range tags, OsmType type) {
  if (type == OsmType::kRelation || says_yes(reading.tag(tags, "area"))) return false;
  const bool road = !reading.tag(tags, "highway").empty() && reading.tag(tags, "highway") != "platform";
  const bool hedge = reading.tag(tags, "barrier") == "hedge" && reading.tag(tags, "landuse").empty();
  return road || hedge || reading.tag(tags, "natural") == "coastline";
}

// Leaves tell what a forest is.
SurfaceClass with_leaves(SurfaceClass surface, LeafType leaves) {
  if (surface != SurfaceClass::kForest) return surface;
  if (leaves == LeafType::kBroad) return SurfaceClass::kBroadLeavedForest;
  if (leaves == LeafType::kNeedle) return SurfaceClass::kNeedleLeavedForest;
  return leaves == LeafType::kMixed ? SurfaceClass::kMixedForest : surface;
}

// What further tags tell about a class.
SurfaceClass refined(const Reading& reading, source::Range tags, SurfaceClass surface, const Growth& growth) {
  const std::string_view wetland = reading.tag(tags, "wetland"), water = reading.tag(tags, "water"),
                         sport = reading.tag(tags, "sport");
  if (surface == SurfaceClass::kWetland && wetland == "marsh") return SurfaceClass::kMarsh;
  if (surface == SurfaceClass::kWetland && wetland == "reedbed") return SurfaceClass::kReedbed;
  if (surface == SurfaceClass::kLake && (water == "river" || water == "canal" || water == "stream"))
    return SurfaceClass::kRiver;
  if (surface == SurfaceClass::kPitch && (sport == "tennis" || sport == "basketball" || sport == "skateboard"))
    return SurfaceClass::kHardCourt;
  return with_leaves(surface, growth.leaves);
}

// Where plants are grown or grow wild.
Growth growth_on(const Reading& reading, const source::Area& area, SurfaceClass surface) {
  const SurfaceGroup group = values_of(surface).group;
  const bool is_green = group == SurfaceGroup::kForest || group == SurfaceGroup::kFarm ||
                        group == SurfaceGroup::kGarden || group == SurfaceGroup::kScrubland ||
                        group == SurfaceGroup::kGrassland || group == SurfaceGroup::kWetland;
  return is_green ? tagged_growth(reading, area.from, area.tags) : Growth{};
}

bool is_underground(const Reading& reading, source::Range tags) {
  return reading.tag(tags, "location") == "underground" || reading.tag(tags, "parking") == "underground" ||
         says_yes(reading.tag(tags, "tunnel")) || reading.tag(tags, "parking") == "multi-storey";
}

}  // namespace

std::vector<AreaFeature> locate_areas(const Reading& reading) {
  std::vector<AreaFeature> areas;
  Account account;
  for (const source::Area& area : reading.osm.areas) {
    const AreaRow* row = row_of(reading, area.tags);
    if ((row == nullptr && !carries_land_key(reading, area.tags)) || is_line(reading, area.tags, area.from.type))
      continue;
    ++account.in;
    if (row == nullptr || row->surface == SurfaceClass::kUnknown) {
      reading.report.drop(account, Code::kUnknownKind, area.from);
      continue;
    }
    if (is_underground(reading, area.tags)) {
      reading.report.drop(account, Code::kUnderground, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(reading, area);
    const Growth growth = growth_on(reading, area, row->surface);
    account.split += polygons.size();
    if (polygons.empty())
      reading.report.drop(account, Code::kDegenerateRing, area.from);
    else
      --account.split;
    for (const LocatedPolygon& polygon : polygons) {
      if (polygon.polygon.outer.empty() || !box_of(polygon.polygon.outer).touches(reading.region)) {
        reading.report.drop(account, Code::kOutsideBounds, area.from);
        continue;
      }
      ++account.out;
      areas.push_back({{area.from, polygon.part},
                       polygon.polygon,
                       refined(reading, area.tags, row->surface, growth),
                       polygon.area_m2,
                       growth});
    }
  }
  reading.report.account("map", "area") = account;
  return areas;
}

}  // namespace citykiln::map
