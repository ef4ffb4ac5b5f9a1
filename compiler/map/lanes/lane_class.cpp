#include "compiler/map/lanes/lane_class.h"

#include <algorithm>
#include <cassert>

#include "compiler/map/land_cover_class.h"
#include "compiler/map/lanes/track_rules.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

struct LaneClassRow {
  std::string_view key, value;
  LaneKind kind;
};
constexpr LaneClassRow kKinds[] = {
#define LANE_CLASS(key, value, kind) {key, value, LaneKind::kind},
#include "compiler/map/lanes/lane_rules.inc"
#undef LANE_CLASS
};

LaneKind kind_of(const TrackRow& track) {
  for (const LaneClassRow& row : kKinds)
    if (row.key == track.key && row.value == track.value) return row.kind;
  return LaneKind::kDriving;
}

// True for roads closed to all traffic except buses.
bool is_for_buses(const LaneTags& tags) {
  const std::string_view bus = tags("bus"), psv = tags("psv");
  const bool is_closed = tags("access") == "no" || tags("vehicle") == "no" || tags("motor_vehicle") == "no";
  return is_closed && (says_yes(bus) || says_yes(psv));
}

struct RegionRow {
  RoadGuidelines guidelines;
  std::string_view value;
  double width_m;
  int lanes;
};
constexpr RegionRow kRegionalWidths[] = {
#define REGIONAL(guidelines, highway, width_m, lanes) {RoadGuidelines::guidelines, highway, width_m, lanes},
#include "compiler/map/lanes/regional_widths.inc"
#undef REGIONAL
};

// The row with the guidelines' width and number of lanes, if they differ.
TrackRow by_guidelines(TrackRow row, RoadGuidelines guidelines) {
  if (row.key != "highway") return row;
  for (const RegionRow& other : kRegionalWidths)
    if (other.guidelines == guidelines && other.value == row.value)
      row.width_m = other.width_m, row.lanes = other.lanes;
  return row;
}

LaneClass class_of(const LaneTags& tags, const TrackRow& usual) {
  const TrackRow row = by_guidelines(usual, tags.guidelines);
  LaneClass result{kind_of(row), row.width_m, row.lanes, row.surface == LandCoverClass::kMotorwayRoad, false, false};
  result.is_road = row.key == "highway" && (result.kind == LaneKind::kDriving || result.kind == LaneKind::kBus);
  result.is_both_ways = !result.is_road && result.kind != LaneKind::kCycle;
  if (result.is_road && is_for_buses(tags)) result.kind = LaneKind::kBus;
  return result;
}

}  // namespace

double LaneClass::width_m_of(double counted) const {
  assert(counted >= 0);
  if (lanes > 0) return std::max(counted * width_m, kMinCountedRoad_m);
  return counted < 2 ? width_m : std::max(width_m, counted * kUncountedLane_m);
}

LaneClass lane_class_of(const LaneTags& tags) {
  if (const TrackRow* row = track_row(tags)) return class_of(tags, *row);
  LaneClass unknown;
  unknown.is_both_ways = true;
  return unknown;
}

}  // namespace citykiln::map
