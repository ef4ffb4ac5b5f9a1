#include "compiler/assume/parking.h"

#include <algorithm>

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {
namespace {

using map::Lane;
using map::LaneDirection;
using map::LaneKind;

struct ParkingRow {
  map::CountryGroup country;
  map::LandCoverClass surface;
  double lane_m;
};
constexpr ParkingRow kParkingRows[] = {
#define PARKING_ROW(country, surface, lane_m) {map::CountryGroup::country, map::LandCoverClass::surface, lane_m},
#include "compiler/assume/parking.inc"
#undef PARKING_ROW
};

// Cars park where buildings stand along more than this share of the side.
constexpr double kParkingHouses = 0.25;
// Two lanes that no tag counts are one below this width, and tagged lanes are never wider than that (map/lanes).
constexpr double kLeastTwoLanes_m = 4.5, kWidestMovingLane_m = 4.5;

double usual_lane_m(const map::Track& track) {
  for (const ParkingRow& row : kParkingRows)
    if (row.country == track.country && row.surface == track.surface) return row.lane_m;
  return 0;
}

// The number of lanes between the kerbs, if all are for driving; else 0.
int driving_lanes(const map::Track& track) {
  int count = 0;
  for (const Lane& lane : track.section.lanes) {
    if (!lane.is_raised && lane.kind != LaneKind::kDriving) return 0;
    count += lane.is_raised ? 0 : 1;
  }
  return count;
}

bool may_have_parking(const map::Track& track) {
  if (usual_lane_m(track) == 0 || track.tagged_parking != 0 || !track.has_tagged_width) return false;
  if (track.passage != map::Passage::kGround || track.is_rail || track.is_indoor || track.is_through_building)
    return false;
  if (track.is_link || track.is_roundabout || track.is_transition || track.has_tagged_placement) return false;
  // the width of a row divides evenly among one, two or four lanes
  const int lanes = driving_lanes(track);
  return track.section.axis_drift == 0 && (lanes == 2 || lanes == 4 || (lanes == 1 && track.is_oneway));
}

// True if the moving lanes of a street are wide enough beside this many rows, and not too wide for their number.
bool has_width_for(const map::Track& track, int rows) {
  const int lanes = driving_lanes(track);
  const double rest_m = carriageway_width_m(track.section) - rows * kParkedRow_m;
  if (lanes == 2 && rest_m < kLeastTwoLanes_m) return false;
  return rest_m >= lanes * usual_lane_m(track) && rest_m <= lanes * kWidestMovingLane_m;
}

bool is_built_up(const SideFacts& side) {
  const bool is_town =
      side.land == LandUse::kResidential || side.land == LandUse::kShops || side.land == LandUse::kNone;
  return is_town && side.houses > kParkingHouses;
}

// Parked cars face with the adjacent traffic.
LaneDirection facing_of(const map::Track& track, bool is_left) {
  const auto level = std::ranges::find(track.section.lanes, false, &Lane::is_raised);
  if (track.is_oneway) return level->way;
  const bool is_backward = is_left == (track.side == map::DrivingSide::kRight);
  return is_backward ? LaneDirection::kBackward : LaneDirection::kForward;
}

void add_row(map::Track& track, bool is_left) {
  const Lane row{.kind = LaneKind::kParking, .way = facing_of(track, is_left), .width_m = kParkedRow_m};
  std::vector<Lane>& lanes = track.section.lanes;
  const auto is_level = [](const Lane& lane) { return !lane.is_raised; };
  if (is_left)
    lanes.insert(std::ranges::find_if(lanes, is_level), row);
  else
    lanes.insert(std::find_if(lanes.rbegin(), lanes.rend(), is_level).base(), row);
}

void add_parking(map::Track& track, std::uint8_t sides) {
  const int rows = sides == map::kBothSides ? 2 : 1, lanes = driving_lanes(track);
  for (Lane& lane : track.section.lanes)
    if (!lane.is_raised) lane.width_m -= rows * kParkedRow_m / lanes;
  if ((sides & map::kLeftSide) != 0) add_row(track, true);
  if ((sides & map::kRightSide) != 0) add_row(track, false);
}

// Returns the sides of a street on which cars are assumed to park, as bits of RoadSide; 0 if streets of this kind never
// get rows, or if the street has no room for one.
std::uint8_t assumed_parking(const map::Track& stretch, const BothSides& sides) {
  if (!may_have_parking(stretch)) return 0;
  const std::uint8_t own = stretch.side == map::DrivingSide::kRight ? map::kRightSide : map::kLeftSide;
  const bool left = is_built_up(sides.left), right = is_built_up(sides.right);
  if (left && right && has_width_for(stretch, 2)) return map::kBothSides;
  if (!(own == map::kLeftSide ? left : right) || !has_width_for(stretch, 1)) return 0;
  return own;
}

}  // namespace

std::vector<map::Track> assume_parking(const map::FeatureView& features, Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  const auto cut = [&](const map::Track& track) {
    const bool may_be_cut = may_have_parking(track) && !track.is_piece;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](map::Track& stretch) {
    if (!may_have_parking(stretch) || length_m(stretch.axis) > kLongestWhole_m) return false;
    const std::uint8_t sides = assumed_parking(stretch, facts_beside(surroundings, stretch));
    if (sides != 0) add_parking(stretch, sides);
    return sides != 0;
  };
  return with_changed_stretches(features.tracks, Assumption::kParking, "parked_track", cut, change, report);
}

}  // namespace citykiln::assume
