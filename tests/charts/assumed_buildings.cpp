// Heights and storeys of buildings, as tagged and as built on level ground.
#include <algorithm>
#include <cmath>

#include "compiler/buildings/plan.h"
#include "compiler/whole_map.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

using buildings::Building;
using map::Footprint;

map::Heightfield level_ground(const Box2& extent) {
  constexpr double kStep_m = 64;
  map::Heightfield ground;
  ground.min = extent.min, ground.step_m = {kStep_m, kStep_m};
  ground.columns = static_cast<int>(std::ceil(extent.width() / kStep_m)) + 1;
  ground.rows = static_cast<int>(std::ceil(extent.height() / kStep_m)) + 1;
  ground.heights.resize(static_cast<std::size_t>(ground.columns) * static_cast<std::size_t>(ground.rows));
  return ground;
}

std::vector<Building> planned_on_level_ground(const map::Features& features) {
  Report ignored;
  const map::Heightfield level = level_ground(features.extent);
  return buildings::plan(features, grade_whole_map({.heights = level}, {}, features.extent), ignored);
}

/// True for buildings of one body that stand on the ground.
bool is_whole_building(const Footprint& footprint) {
  return !footprint.is_part && !footprint.has_parts && !footprint.outline && !footprint.is_open &&
         footprint.min_height_m == 0;
}

/// Samples of the buildings for which `is_tagged(footprint)`, with the values that are built of them.
template <typename IsTagged>
std::vector<Sample> building_samples(const map::Features& features, const Values& built, IsTagged is_tagged) {
  std::vector<Sample> samples;
  for (const Footprint& footprint : features.footprints) {
    const auto value = built.find({footprint.id.osm, 0});
    if (footprint.id.part != 0 || !is_whole_building(footprint) || !is_tagged(footprint) || value == built.end())
      continue;
    samples.push_back({.key = value->first,
                       .at = box_of(footprint.polygon.outer).centre(),
                       .kind = footprint.building_class,
                       .tagged = value->second});
  }
  return samples;
}

}  // namespace

std::vector<Sample> tagged_heights(const Place& place) {
  return building_samples(place.mapped, built_heights(place.mapped),
                          [](const Footprint& footprint) { return footprint.has_roof_in_height; });
}

Values built_heights(const map::Features& features) {
  Values heights_m;
  for (const Building& building : planned_on_level_ground(features))
    if (building.id.part == 0) heights_m[{building.id.osm, 0}] = building.top_m;
  return heights_m;
}

std::vector<Sample> tagged_storeys(const Place& place) {
  return building_samples(place.mapped, built_storeys(place.mapped),
                          [](const Footprint& footprint) { return footprint.levels > 0; });
}

Values built_storeys(const map::Features& features) {
  Values storeys;
  for (const Building& building : planned_on_level_ground(features))
    if (building.id.part == 0) storeys[{building.id.osm, 0}] = building.levels;
  return storeys;
}

}  // namespace citykiln::charts
