#include "compiler/roads/junctions/circular_nodes.h"

#include <algorithm>

namespace citykiln::roads {
namespace {

double least_radius_m(map::TrackPointKind kind) {
  using map::TrackPointKind;
  return kind == TrackPointKind::kTurningCircle ? 6 : kind == TrackPointKind::kMiniRoundabout ? 5 : 0;
}

double told_by_m(const Road& road, std::uint32_t vertex) {
  double radius_m = 0;
  for (const map::TrackPoint& point : road.points)
    if (point.vertex == vertex) radius_m = std::max(radius_m, least_radius_m(point.kind));
  return radius_m;
}

}  // namespace

double disk_radius_m(std::span<const Road> roads, std::span<const Arm> arms) {
  constexpr double kMargin_m = 1.5, kLargest_m = 12;
  double told_m = 0, half_m = 0;
  for (const Arm& arm : arms) {
    told_m = std::max(told_m, told_by_m(roads[arm.road], arm.vertex));
    half_m = std::max({half_m, left_of(roads, arm), right_of(roads, arm)});
  }
  return told_m == 0 ? 0 : std::min(kLargest_m, std::max(told_m, half_m + kMargin_m));
}

}  // namespace citykiln::roads
