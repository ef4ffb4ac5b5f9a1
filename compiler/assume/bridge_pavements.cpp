#include "compiler/assume/bridge_pavements.h"

#include <algorithm>
#include <utility>

#include "compiler/contract/equal_span.h"

namespace citykiln::assume {
namespace {

using map::Track;

bool is_road_track(const Track& track) {
  return map::values_of(track.surface).group == map::LandCoverGroup::kRoad && !track.is_rail && !track.is_indoor;
}

// An end of a street on the ground, at a map node.
struct StreetEnd {
  std::int64_t node = 0;
  std::uint32_t track = 0;
  bool is_last = false;
};

std::vector<StreetEnd> street_ends(const std::vector<Track>& tracks) {
  std::vector<StreetEnd> ends;
  for (std::uint32_t t = 0; t < tracks.size(); ++t) {
    if (!is_road_track(tracks[t]) || tracks[t].passage != map::Passage::kGround) continue;
    ends.push_back({tracks[t].node_ids.front(), t, false});
    ends.push_back({tracks[t].node_ids.back(), t, true});
  }
  std::ranges::sort(ends, {}, [](const StreetEnd& end) { return std::pair(end.node, end.track); });
  return ends;
}

// The width of the outermost pavement on a side; 0 without.
double pavement_m(const Track& track, bool is_left) {
  const map::Lane& lane = is_left ? track.section.lanes.front() : track.section.lanes.back();
  return lane.kind == map::LaneKind::kSidewalk ? lane.width_m : 0;
}

// Widths on the left and right of the street that goes on from an end of a bridge, as seen along the bridge.
struct Beside {
  double left_m = 0, right_m = 0;
};

Beside beside_end(const std::vector<Track>& tracks, const std::vector<StreetEnd>& ends, const Track& bridge,
                  bool is_last) {
  const std::int64_t node = is_last ? bridge.node_ids.back() : bridge.node_ids.front();
  const auto streets = equal_span(ends, node, &StreetEnd::node);
  if (streets.size() != 1) return {};
  const StreetEnd& end = streets.front();
  const Track& street = tracks[end.track];
  // two ways in a row point the same way if one ends where the other begins
  const bool is_reversed = end.is_last == is_last;
  return {pavement_m(street, !is_reversed), pavement_m(street, is_reversed)};
}

bool may_have_bridge_pavement(const Track& track) {
  return is_road_track(track) && track.passage == map::Passage::kBridge && track.tagged_pavements != map::kBothSides &&
         track.section.axis_drift == 0 && length_m(track.axis) <= kLongestBridge_m;
}

}  // namespace

std::vector<Track> assume_bridge_pavements(std::span<const Track> without, Report& report) {
  std::vector<Track> tracks(without.begin(), without.end());
  const std::vector<StreetEnd> ends = street_ends(tracks);
  for (Track& bridge : tracks) {
    if (!may_have_bridge_pavement(bridge)) continue;
    const Beside before = beside_end(tracks, ends, bridge, false), after = beside_end(tracks, ends, bridge, true);
    const double widths_m[] = {std::min(before.left_m, after.left_m), std::min(before.right_m, after.right_m)};
    bool is_any = false;
    for (const std::uint8_t side : {map::kLeftSide, map::kRightSide}) {
      const double width_m = widths_m[side == map::kRightSide];
      if (width_m <= 0 || (bridge.tagged_pavements & side) != 0) continue;
      bridge.section = with_pavement(std::move(bridge.section), side, width_m);
      bridge.assumed_sides |= side;
      is_any = true;
    }
    if (!is_any) continue;
    bridge.assumed |= bit_of(Assumption::kPavements);
    report.count_assumed(Assumption::kPavements, bridge.id.osm);
  }
  return tracks;
}

}  // namespace citykiln::assume
