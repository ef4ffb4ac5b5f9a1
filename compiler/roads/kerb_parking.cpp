#include "compiler/roads/kerb_parking.h"

#include <algorithm>

namespace citykiln::roads {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneKind;

bool is_main(const map::Track& track) { return track.surface == LandCoverClass::kTertiaryRoad; }

bool may_have_rows(const map::Track& track) {
  if (track.surface != LandCoverClass::kResidentialRoad && !is_main(track)) return false;
  if (track.passage != map::Passage::kGround || track.is_link || track.is_roundabout || track.is_transition)
    return false;
  return !track.is_through_building && !track.is_covered && !track.is_indoor;
}

// The width of the lanes for driving; 0 if there are others for traffic.
double driving_m(const map::Track& track) {
  double width_m = 0;
  for (const Lane& lane : track.section.lanes) {
    if (lane.is_raised || lane.kind == LaneKind::kParking || lane.kind == LaneKind::kBuffer) continue;
    if (lane.kind != LaneKind::kDriving) return 0;
    width_m += lane.width_m;
  }
  return width_m;
}

bool is_free(const map::Track& track, bool is_left) {
  if ((track.tagged_parking & (is_left ? map::kLeftSide : map::kRightSide)) != 0) return false;
  const Lane& lane = map::lane_at_kerb(track.section, is_left);
  return lane.kind == LaneKind::kDriving && lane.turns == 0;
}

bool has_lines(const map::Track& track) {
  const auto is_driven = [](const Lane& lane) { return lane.kind == LaneKind::kDriving; };
  return is_main(track) && std::ranges::count_if(track.section.lanes, is_driven) > 1;
}

}  // namespace

std::uint8_t kerb_parking_of(const map::Track& track) {
  if (!may_have_rows(track)) return 0;
  const bool left = is_free(track, true), right = is_free(track, false);
  const double width_m = driving_m(track);
  const bool may_have_two = !(track.is_oneway && is_main(track));
  if (left && right && may_have_two && width_m >= (has_lines(track) ? kTwoRowsBesideLanes_m : kTwoRows_m))
    return map::kBothSides;
  if (!(left || right) || width_m < (has_lines(track) ? kOneRowBesideLanes_m : kOneRow_m)) return 0;
  const bool is_own_left = track.side == map::DrivingSide::kLeft;
  const bool is_left = is_own_left ? left : !right;
  return is_left ? map::kLeftSide : map::kRightSide;
}

}  // namespace citykiln::roads
