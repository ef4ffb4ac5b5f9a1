#include "compiler/map/lanes/narrowest_lanes.h"

#include <algorithm>

namespace citykiln::map {
namespace {

struct ClassRow {
  LandCoverClass surface;
  double metres;
};
constexpr ClassRow kDrivingLanes[] = {
#define NARROWEST(surface, metres) {LandCoverClass::surface, metres},
#include "compiler/map/lanes/lane_rules.inc"
#undef NARROWEST
};

struct NarrowestRow {
  LaneKind kind;
  double metres;
};
constexpr NarrowestRow kOtherLanes[] = {
#define NARROWEST_KIND(kind, metres) {LaneKind::kind, metres},
#include "compiler/map/lanes/lane_rules.inc"
#undef NARROWEST_KIND
};

constexpr double kVehicle_m = 2.5;

}  // namespace

double narrowest_m(const Lane& lane, LandCoverClass surface) {
  const auto* other = std::ranges::find(kOtherLanes, lane.kind, &NarrowestRow::kind);
  if (other != std::end(kOtherLanes)) return other->metres;
  const auto* row = std::ranges::find(kDrivingLanes, surface, &ClassRow::surface);
  const double least_m = row != std::end(kDrivingLanes) ? row->metres : kVehicle_m;
  return lane.way == LaneDirection::kBoth ? std::max(least_m, kVehicle_m) : least_m;
}

}  // namespace citykiln::map
