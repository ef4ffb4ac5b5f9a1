// A made street with houses, for tests of lots and yards.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/lots/add_yards.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::lots {

inline Ring rectangle(Vec2 least, Vec2 most) { return {least, {most.x, least.y}, most, {least.x, most.y}}; }

inline map::Track street(std::int64_t id, Polyline axis,
                         map::LandCoverClass surface = map::LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = std::move(axis);
  for (std::size_t i = 0; i < track.axis.size(); ++i) track.node_ids.push_back(100 * id + static_cast<std::int64_t>(i));
  track.surface = surface;
  const map::Lane pavement{.kind = map::LaneKind::kSidewalk, .width_m = 2, .is_raised = true};
  track.section.lanes = {pavement, {.width_m = 6}, pavement};
  track.section.axis_offset_m = 3;
  return track;
}

inline map::Track path(std::int64_t id, Polyline axis,
                       map::LandCoverClass surface = map::LandCoverClass::kPavedFootPath) {
  map::Track track = street(id, std::move(axis), surface);
  track.section.lanes = {{.kind = map::LaneKind::kFoot, .width_m = 2}};
  track.section.axis_offset_m = 1;
  return track;
}

inline map::Footprint house(std::int64_t id, Vec2 least, Vec2 most,
                            map::CountryGroup country = map::CountryGroup::kCentralEurope) {
  map::Footprint house;
  house.id = {{OsmType::kWay, id}, 0};
  house.polygon.outer = rectangle(least, most);
  house.height_m = 6;
  house.building_class = static_cast<std::uint8_t>(map::BuildingClass::kHouse);
  house.country = country;
  return house;
}

inline map::AreaFeature land(std::int64_t id, Vec2 least, Vec2 most, map::LandCoverClass surface) {
  map::AreaFeature area;
  area.id = {{OsmType::kWay, id}, 0};
  area.polygon.outer = rectangle(least, most);
  area.surface = surface;
  area.area_m2 = area_m2(area.polygon);
  return area;
}

/// A street along y = 0 whose pavements end at y = ±5, with houses of 12 by 10 m every 24 m on its left, 8 m behind the
/// pavement. Their ids are 1000, 1001 …
inline map::Features made_town(map::CountryGroup country = map::CountryGroup::kCentralEurope, int houses = 8) {
  map::Features features;
  features.extent = {{-256, -256}, {256, 256}};
  features.tracks = {street(1, {{-150, 0}, {150, 0}})};
  features.areas = {land(50, {-250, -100}, {250, 100}, map::LandCoverClass::kResidential)};
  for (int i = 0; i < houses; ++i)
    features.footprints.push_back(house(1000 + i, {24.0 * i - 96, 13}, {24.0 * i - 84, 23}, country));
  return features;
}

/// The stages before yards, then yards.
inline map::Features town_with_yards(map::Features features, Report& report, std::vector<OsmId> private_ways = {},
                                     climate::ClimateClass climate = climate::ClimateClass::kCfb) {
  std::ranges::sort(features.tracks, {}, &map::Track::id);
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, report);
  const ClimateAt climate_at = [=](Vec2) { return climate; };
  Yards yards = with_yards(features,
                           {.roads = roads,
                            .junctions = junctions,
                            .private_ways = private_ways,
                            .climate_at = climate_at,
                            .seed = 1,
                            .threads = 1},
                           report);
  features.footprints = std::move(yards.footprints), features.areas = std::move(yards.areas);
  features.sports_areas = std::move(yards.sports_areas), features.barriers = std::move(yards.barriers);
  features.points = std::move(yards.points);
  return features;
}
inline map::Features town_with_yards(map::Features features) {
  Report report;
  return town_with_yards(std::move(features), report);
}

/// The lots of a map.
inline std::vector<Lot> lots_of_town(const map::Features& features) {
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  const ClimateAt climate_at = [](Vec2) { return climate::ClimateClass::kCfb; };
  return lots_of_map(features, {.roads = roads, .junctions = {}, .private_ways = {}, .climate_at = climate_at});
}

/// True for objects that yards add.
inline bool is_of_yard(ObjectId id) { return is_derived(id); }

/// The areas of yards with a class.
inline std::vector<Polygon> yard_areas(const map::Features& features, map::LandCoverClass surface) {
  std::vector<Polygon> areas;
  for (const map::AreaFeature& area : features.areas)
    if (is_of_yard(area.id) && area.surface == surface) areas.push_back(area.polygon);
  return areas;
}

inline bool is_in_any(const std::vector<Polygon>& areas, Vec2 p) {
  return std::ranges::any_of(areas, [&](const Polygon& area) { return contains(area, p); });
}

}  // namespace citykiln::lots
