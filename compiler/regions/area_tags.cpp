#include "compiler/regions/area_tags.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "compiler/ground/water/standing_water.h"
#include "compiler/map/land_cover/area_rules.h"

namespace citykiln::regions {
namespace {

using map::LandCoverClass;

struct PlantRow {
  LandCoverClass surface;
  PlantDensity density;
};

struct StructureRow {
  std::string_view key, value;
};

constexpr StructureRow kStructures[] = {
#define STRUCTURE(key, value, building) {key, value},
#include "compiler/map/buildings/structure_values.inc"
#undef STRUCTURE
};

constexpr double kHectare_m2 = 1e4;

constexpr PlantRow kPlants[] = {
#define WOOD(surface, community, trees_per_ha, height_m) \
  {LandCoverClass::surface, {.trees_per_m2 = trees_per_ha / kHectare_m2, .plantings_per_m2 = 0}},
#include "compiler/plants/wood_defaults.inc"
#define PLANTING(surface, species, row_spacing_m, plant_spacing_m, height_m) \
  {LandCoverClass::surface, {.trees_per_m2 = 0, .plantings_per_m2 = 1 / (row_spacing_m * plant_spacing_m)}},
#include "compiler/plants/planting_defaults.inc"
};

bool has(const osmium::TagList& tags, std::string_view key) { return tags.has_key(std::string(key).c_str()); }

bool matches(const map::AreaRule& row, const osmium::TagList& tags) {
  const char* value = tags.get_value_by_key(std::string(row.key).c_str());
  return value != nullptr && (row.value == "*" || row.value == value);
}

bool is_structure(const osmium::TagList& tags) {
  return std::ranges::any_of(kStructures, [&](const StructureRow& row) {
    return tags.has_tag(std::string(row.key).c_str(), std::string(row.value).c_str());
  });
}

bool is_water(LandCoverClass surface) {
  return ground::is_standing(surface) || surface == LandCoverClass::kRiver || surface == LandCoverClass::kSea;
}

}  // namespace

bool describes_building(const osmium::TagList& tags) { return has(tags, "building") || has(tags, "building:part"); }

bool describes_area(const osmium::TagList& tags) {
  if (describes_building(tags) || is_structure(tags)) return true;
  for (const char* key : {"disused:building", "abandoned:building", "ruins:building", "construction:building"})
    if (tags.has_key(key)) return true;
  return std::ranges::any_of(map::area_rules(), [&](const map::AreaRule& row) {
    return row.surface != LandCoverClass::kUnknown && matches(row, tags);
  });
}

bool describes_water(const osmium::TagList& tags) {
  if (has(tags, "waterway") || is_coastline(tags)) return true;
  return std::ranges::any_of(map::area_rules(),
                             [&](const map::AreaRule& row) { return is_water(row.surface) && matches(row, tags); });
}

bool is_coastline(const osmium::TagList& tags) { return tags.has_tag("natural", "coastline"); }

PlantDensity plant_density(const osmium::TagList& tags) {
  const std::span<const map::AreaRule> rules = map::area_rules();
  const auto row = std::ranges::find_if(rules, [&](const map::AreaRule& each) { return matches(each, tags); });
  if (row == rules.end()) return {};
  const auto plants = std::ranges::find(kPlants, row->surface, &PlantRow::surface);
  return plants == std::end(kPlants) ? PlantDensity{} : plants->density;
}

bool is_area_relation(const osmium::TagList& tags) {
  return tags.has_tag("type", "multipolygon") || (tags.has_tag("type", "boundary") && describes_area(tags));
}

bool is_kept_with_members(const osmium::TagList& tags) {
  return is_area_relation(tags) || tags.has_tag("type", "building");
}

}  // namespace citykiln::regions
