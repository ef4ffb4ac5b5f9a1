// Land of real extracts: what a caller of parcels makes of a map.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <unordered_set>

#include "compiler/map/land_cover_class.h"
#include "compiler/map/locate.h"
#include "compiler/parcels/parcels.h"
#include "compiler/source/read_osm.h"

namespace citykiln::parcels {

/// Returns the ids of ways within lots: drives and aisles of car parks.
inline std::unordered_set<std::int64_t> private_ways(const source::OsmData& osm) {
  std::unordered_set<std::int64_t> ways;
  for (const source::Way& way : osm.ways) {
    const std::string_view service = osm.value_of(way.tags, "service");
    if (service == "driveway" || service == "parking_aisle" || service == "drive-through") ways.insert(way.id);
  }
  return ways;
}

inline LineKind kind_of(const map::Track& track, const std::unordered_set<std::int64_t>& private_ways_of_map) {
  if (track.passage != map::Passage::kGround || track.is_through_building || track.is_indoor) return LineKind::kNone;
  const map::LandCoverGroup group = map::values_of(track.surface).group;
  if (track.surface == map::LandCoverClass::kTram || private_ways_of_map.contains(track.id.osm.id))
    return LineKind::kNone;
  if (track.is_rail || track.surface == map::LandCoverClass::kMotorwayRoad) return LineKind::kBarrier;
  return group == map::LandCoverGroup::kRoad ? LineKind::kStreet : LineKind::kNone;
}

inline Line line_of(const map::Track& track, LineKind kind) {
  double before = 0, all = map::total_width_m(track.section);
  for (const map::Lane& lane : track.section.lanes) {
    if (!lane.is_raised) break;
    before += lane.width_m;
  }
  const double left = before + track.section.axis_offset_m;
  return {.id = stable_id(track.id), .axis = track.axis, .left_m = left, .right_m = all - left, .kind = kind};
}

inline bool is_taken(const map::AreaFeature& area) {
  using Group = map::LandCoverGroup;
  const Group group = map::values_of(area.surface).group;
  return group == Group::kWater || group == Group::kForest || group == Group::kPaved || group == Group::kSport ||
         group == Group::kWetland || group == Group::kRoad || area.surface == map::LandCoverClass::kPark ||
         area.surface == map::LandCoverClass::kCemetery;
}

inline Land land_of(const map::Features& features, const source::OsmData& osm) {
  Land land;
  land.extent = features.extent;
  const auto hidden = private_ways(osm);
  for (const map::Track& track : features.tracks) land.lines.push_back(line_of(track, kind_of(track, hidden)));
  for (const map::Waterway& river : features.waterways)
    if (river.passage == map::Passage::kGround && river.width_m >= 3)
      land.lines.push_back({.id = stable_id(river.id),
                            .axis = river.axis,
                            .left_m = river.width_m / 2,
                            .right_m = river.width_m / 2,
                            .kind = LineKind::kBarrier});
  for (const map::AreaFeature& area : features.areas)
    if (is_taken(area)) land.taken.push_back(area.polygon);
  for (const map::Footprint& footprint : features.footprints)
    if (!footprint.is_part) land.footprints.push_back({stable_id(footprint.id), footprint.polygon.outer});
  return land;
}

inline Land land_of_file(const std::filesystem::path& path) {
  Report report;
  auto osm = source::read_osm(path.string(), 2, report);
  EXPECT_TRUE(osm) << path;
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  return land_of(map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, report), *osm);
}

}  // namespace citykiln::parcels
