#include <algorithm>
#include <map>
#include <string>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/bridge_areas.h"
#include "compiler/map/land_cover/area_rules.h"
#include "compiler/map/readers/feature_readers.h"
#include "compiler/map/readers/plant_tags.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

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
#include "compiler/map/land_cover/pitch_surfaces.inc"
#undef SURFACE
#undef SPORT
};
constexpr ValueClass kPitchSports[] = {
#define SURFACE(value, class)
#define SPORT(value, class) {value, LandCoverClass::class},
#include "compiler/map/land_cover/pitch_surfaces.inc"
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

bool is_building(const ReadContext& context, source::Range tags) {
  const std::string_view value = standing_value(context.osm, tags, "building");
  return !value.empty() && value != "no";
}

// The class of a sports track by its surface; tartan is that of tracks.
LandCoverClass sports_track_class(std::string_view surface, LandCoverClass track) {
  if (surface.empty()) return track;
  const LandCoverClass found = pitch_class(surface, "");
  return found == LandCoverClass::kHardCourt || found == LandCoverClass::kPitch ? track : found;
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
  if (surface == LandCoverClass::kRunningTrack) return sports_track_class(context.tag(tags, "surface"), surface);
  if (surface == LandCoverClass::kPitch && context.tag(tags, "leisure") == "pitch")
    return pitch_class(context.tag(tags, "surface"), sport);
  return with_leaves(surface, plant_tags.leaves);
}

// A lake or basin below this area is a pond.
constexpr double kPond_m2 = 20000;

LandCoverClass of_size(LandCoverClass surface, double area_m2) {
  const bool is_lake =
      surface == LandCoverClass::kLake || surface == LandCoverClass::kReservoir || surface == LandCoverClass::kBasin;
  return is_lake && area_m2 < kPond_m2 ? LandCoverClass::kPond : surface;
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

struct SportWidth {
  std::string_view value;
  double width_m;
};
// Widths of tracks: six lanes of 1.22 m for runners by default.
constexpr SportWidth kSportWidths[] = {{"horse_racing", 18}, {"equestrian", 12}, {"motor", 10},
                                       {"karting", 8},       {"motocross", 6},   {"cycling", 7}};
constexpr double kRunning_m = 7.5;
constexpr double kLane_m = 1.22, kLeastTrack_m = 1, kMostTrack_m = 60, kMostRunningLanes = 14;

// The width of a track by width=*, by its lanes, else by its sport.
double width_of_sports_track_m(const ReadContext& context, OsmId id, source::Range tags) {
  if (const auto width_m = tagged_length_m(context, id, tags, "width", kLeastTrack_m, kMostTrack_m)) return *width_m;
  const auto lanes = number_within(context, id, "lanes", context.tag(tags, "lanes"), 1, kMostRunningLanes);
  if (lanes) return *lanes * kLane_m;
  const std::string_view sport = context.tag(tags, "sport").substr(0, context.tag(tags, "sport").find(';'));
  const SportWidth* row = row_with(kSportWidths, sport);
  return row != nullptr ? row->width_m : kRunning_m;
}

Polygon moved_by(const Polygon& polygon, Vec2 by) {
  Polygon moved = polygon;
  for (Vec2& p : moved.outer) p = snapped(p + by);
  for (Ring& hole : moved.holes)
    for (Vec2& p : hole) p = snapped(p + by);
  return moved;
}

// The band of a width along a closed line. The area itself if it is hardly wider: it is the band's outline.
Polygon band_along(const Polygon& line, double width_m) {
  Ring closed = line.outer;
  closed.push_back(closed.front());
  constexpr double kOutline = 1.5;
  if (2 * std::abs(signed_area_m2(line.outer)) < kOutline * width_m * length_m(closed)) return line;
  const Vec2 near = line.outer.front();
  const Polygon local = moved_by({line.outer, {}}, near * -1.0);
  const std::vector<double> half_m(local.outer.size(), width_m / 2);
  const OffsetPolygon outer = outset(local, half_m), inner = inset(local, half_m);
  if (outer.moved.size() != 1) return line;
  Polygon band{outer.moved.front().outer, {}};
  for (const Polygon& hole : inner.moved) {
    band.holes.push_back(hole.outer);
    std::ranges::reverse(band.holes.back());
  }
  return moved_by(band, near);
}

// True for a closed way that is the middle line of a sports track.
bool is_line_of_track(const ReadContext& context, const source::Area& area) {
  return area.from.type == OsmType::kWay && context.tag(area.tags, "leisure") == "track" &&
         !says_yes(context.tag(area.tags, "area"));
}

// The polygons of an area; of a track that is mapped by its line, the band along it.
std::vector<LocatedPolygon> located_surface(const ReadContext& context, const source::Area& area) {
  std::vector<LocatedPolygon> polygons = located(context, area);
  if (!is_line_of_track(context, area)) return polygons;
  const double width_m = width_of_sports_track_m(context, area.from, area.tags);
  for (LocatedPolygon& located : polygons) {
    if (located.polygon.outer.size() < 3) continue;
    located.polygon = band_along(located.polygon, width_m);
    located.area_m2 = area_m2(located.polygon);
  }
  return polygons;
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
  const bool taxiway = context.tag(tags, "aeroway") == "taxiway";
  // loops of skiing are courses through woods and fields
  const bool course = context.tag(tags, "leisure") == "track" && context.tag(tags, "sport") == "skiing";
  return road || hedge || landform || taxiway || course || natural == "coastline";
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
      // a car park that is a building is that building
      if (*reason == Code::kInsideBuilding && is_building(context, area.tags))
        account.merged += context.report.counts(area.from);
      else
        context.report.drop(account, *reason, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located_surface(context, area);
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
                       .surface = of_size(surface, polygon.area_m2),
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
