#include <algorithm>
#include <array>

#include "compiler/geometry/snap.h"
#include "compiler/map/building_classes.h"
#include "compiler/map/locate_parts.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

using materials::Material;

// The steps of monuments are parts a few decimetres high.
constexpr double kLowest_m = 0.1, kHighest_m = 1000, kMostLevels = 250;

struct MaterialRow {
  std::string_view value;
  Material material;
};
constexpr MaterialRow kWalls[] = {{"brick", Material::kBrick},
                                  {"bricks", Material::kBrick},
                                  {"concrete", Material::kConcrete},
                                  {"stone", Material::kStone},
                                  {"sandstone", Material::kStone},
                                  {"limestone", Material::kStone},
                                  {"granite", Material::kStone},
                                  {"wood", Material::kTimber},
                                  {"timber_framing", Material::kPlaster},
                                  {"plaster", Material::kPlaster},
                                  {"cement_block", Material::kConcrete},
                                  {"glass", Material::kGlassFacade},
                                  {"mirror", Material::kGlassFacade},
                                  {"metal", Material::kMetalCladding},
                                  {"steel", Material::kMetalCladding},
                                  {"metal_plates", Material::kMetalCladding}};
constexpr MaterialRow kRoofs[] = {
    {"roof_tiles", Material::kRoofTile}, {"tile", Material::kRoofTile},     {"tiles", Material::kRoofTile},
    {"slate", Material::kSlate},         {"metal", Material::kMetalRoof},   {"copper", Material::kMetalRoof},
    {"zinc", Material::kMetalRoof},      {"concrete", Material::kFlatRoof}, {"tar_paper", Material::kFlatRoof},
    {"gravel", Material::kFlatRoof},     {"eternit", Material::kSlate},     {"grass", Material::kGrass},
    {"glass", Material::kGlassFacade}};

std::optional<Material> material_of(std::string_view value, std::span<const MaterialRow> rows) {
  for (const MaterialRow& row : rows)
    if (row.value == value) return row.material;
  return std::nullopt;
}

// The first of the two keys that is tagged.
std::optional<Srgb> tagged_colour(const Reading& reading, OsmId id, source::Range tags, std::string_view british,
                                  std::string_view american) {
  std::string_view text = reading.tag(tags, british);
  if (text.empty()) text = reading.tag(tags, american);
  if (text.empty()) return std::nullopt;
  const auto colour = colour_of(text);
  if (!colour) reading.report.add(Code::kBadTagValue, id);
  return colour;
}

std::optional<double> tagged_number(const Reading& reading, OsmId id, source::Range tags, std::string_view key) {
  const std::string_view text = reading.tag(tags, key);
  if (text.empty()) return std::nullopt;
  const auto number = number_of(text);
  if (number && *number >= 0 && *number <= kMostLevels) return number;
  reading.report.add(Code::kBadTagValue, id);
  return std::nullopt;
}

// Untagged: sheds are low, houses have two storeys and a roof, town blocks four to five.
double height_by_area_m(double area_m2) {
  return area_m2 < 25 ? 2.8 : area_m2 < 70 ? 4.5 : area_m2 < 220 ? 7.5 : area_m2 < 700 ? 11 : 13;
}

struct Heights {
  double height_m, min_height_m;
};

Heights heights_of(const Reading& reading, OsmId id, source::Range tags, BuildingClass building, double area_m2) {
  const BuildingValues& values = values_of(building);
  const auto levels = tagged_number(reading, id, tags, "building:levels");
  const auto roof_levels = tagged_number(reading, id, tags, "roof:levels");
  const auto roof_m = tagged_length_m(reading, id, tags, "roof:height", 0, kHighest_m);
  auto height = tagged_length_m(reading, id, tags, "height", kLowest_m, kHighest_m);
  if (!height) height = tagged_length_m(reading, id, tags, "building:height", kLowest_m, kHighest_m);
  if (!height && (levels || roof_levels))
    height =
        std::max(1.0, levels.value_or(0) * values.level_m + roof_m.value_or(roof_levels.value_or(0) * values.level_m));
  if (!height) reading.report.add(Code::kNoBuildingHeight, id);
  if (!height) height = values.height_m > 0 ? values.height_m : height_by_area_m(area_m2);
  auto min_height = tagged_length_m(reading, id, tags, "min_height", 0, kHighest_m);
  if (!min_height)
    if (const auto level = tagged_number(reading, id, tags, "building:min_level")) min_height = *level * values.level_m;
  // compared as they will be stored
  const Heights heights{snapped(*height), snapped(min_height.value_or(0))};
  if (heights.min_height_m < heights.height_m) return heights;
  reading.report.add(Code::kUpsideDown, id, heights.min_height_m - heights.height_m);
  return {heights.height_m, 0};
}

// What is said once for all polygons of an element.
Footprint described(const Reading& reading, const source::Area& area, std::string_view value, double area_m2) {
  Footprint footprint;
  const BuildingClass building = building_class_of(value);
  const Heights heights = heights_of(reading, area.from, area.tags, building, area_m2);
  footprint.building_class = static_cast<std::uint8_t>(building);
  footprint.height_m = heights.height_m;
  footprint.min_height_m = heights.min_height_m;
  footprint.wall_colour = tagged_colour(reading, area.from, area.tags, "building:colour", "building:color");
  footprint.roof_colour = tagged_colour(reading, area.from, area.tags, "roof:colour", "roof:color");
  footprint.wall_material = material_of(reading.tag(area.tags, "building:material"), kWalls);
  footprint.roof_material = material_of(reading.tag(area.tags, "roof:material"), kRoofs);
  return footprint;
}

// Parts replace an outline that they cover by more than this: a lone roof terrace mapped as a part does not.
constexpr double kCoveringShare = 0.6;

Vec2 inner_point(const Polygon& polygon) {
  // the middle of the longest ear's diagonal would do too; a vertex drawn a little inside is enough to tell parts from
  // neighbours
  const Vec2 centre = box_of(polygon.outer).centre();
  if (contains(polygon, centre)) return centre;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    const Vec2 a = polygon.outer[i], b = polygon.outer[(i + 1) % polygon.outer.size()];
    const Vec2 p = (a + b) * 0.5 + unit(left_of(b - a)) * 0.05;
    if (contains(polygon, p)) return p;
  }
  return polygon.outer.front();
}

void mark_outlines(std::vector<Footprint>& footprints) {
  std::vector<std::size_t> outlines;
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (!footprints[i].is_part) outlines.push_back(i);
  const auto west = [&](std::size_t i) { return box_of(footprints[i].polygon.outer).min.x; };
  std::sort(outlines.begin(), outlines.end(), [&](auto a, auto b) { return west(a) < west(b); });
  std::vector<double> edges, covered(footprints.size(), 0);
  double widest = 0;
  for (const std::size_t i : outlines) {
    edges.push_back(west(i));
    widest = std::max(widest, box_of(footprints[i].polygon.outer).width());
  }
  for (const Footprint& part : footprints) {
    if (!part.is_part) continue;
    const Vec2 p = inner_point(part.polygon);
    const auto end = std::upper_bound(edges.begin(), edges.end(), p.x);
    const auto begin = std::lower_bound(edges.begin(), edges.end(), p.x - widest);
    for (auto edge = begin; edge != end; ++edge) {
      const std::size_t i = outlines[static_cast<std::size_t>(edge - edges.begin())];
      if (box_of(footprints[i].polygon.outer).contains(p) && contains(footprints[i].polygon, p))
        covered[i] += area_m2(part.polygon);
    }
  }
  for (const std::size_t i : outlines)
    footprints[i].has_parts = covered[i] > kCoveringShare * area_m2(footprints[i].polygon);
}

}  // namespace

std::vector<Footprint> locate_footprints(const Reading& reading) {
  std::vector<Footprint> footprints;
  Account account;
  for (const source::Area& area : reading.osm.areas) {
    const std::string_view outline = reading.tag(area.tags, "building"), part = reading.tag(area.tags, "building:part");
    if (!says_yes(outline) && !says_yes(part)) continue;
    ++account.in;
    if (reading.tag(area.tags, "location") == "underground") {
      reading.report.drop(account, Code::kUnderground, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(reading, area);
    if (polygons.empty()) {
      reading.report.drop(account, Code::kDegenerateRing, area.from);
      continue;
    }
    account.split += polygons.size() - 1;
    Footprint footprint =
        described(reading, area, says_yes(part) && !says_yes(outline) ? part : outline, polygons.front().area_m2);
    footprint.is_part = says_yes(part) && !says_yes(outline);
    for (const LocatedPolygon& polygon : polygons) {
      if (polygon.polygon.outer.empty() || !box_of(polygon.polygon.outer).touches(reading.region)) {
        reading.report.drop(account, Code::kOutsideBounds, area.from);
        continue;
      }
      ++account.out;
      footprint.id = {area.from, polygon.part};
      footprint.polygon = polygon.polygon;
      footprints.push_back(footprint);
    }
  }
  reading.report.account("map", "footprint") = account;
  mark_outlines(footprints);
  return footprints;
}

}  // namespace citykiln::map
