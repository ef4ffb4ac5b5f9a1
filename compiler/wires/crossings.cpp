#include "compiler/wires/crossings.h"

#include "compiler/geometry/segment.h"

namespace citykiln::wires {
namespace {

constexpr double kCrossingBucket_m = 64;

bool is_crossed(map::LandCoverClass surface) {
  const map::LandCoverGroup group = map::values_of(surface).group;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kRail;
}

// Segments of a road; with a profile, their heights.
template <typename Road>
void add_segments(const Road& road, bool is_bridge, Crossings& crossings, std::vector<Box2>& boxes) {
  if (!is_crossed(road.surface)) return;
  double along_m = road.start_along_m;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    Crossings::Segment segment{road.axis[i], road.axis[i + 1], {}, {}};
    const double end_m = along_m + distance(segment.a, segment.b);
    if (is_bridge && !road.profile.empty())
      segment.a_m = knot_at(road.profile, along_m).z_m, segment.b_m = knot_at(road.profile, end_m).z_m;
    along_m = end_m;
    crossings.segments.push_back(segment);
    boxes.push_back(box_of_segment(segment.a, segment.b));
  }
}

}  // namespace

Crossings index_crossings(std::span<const roads::Road> roads, std::span<const structures::Span> bridges) {
  Crossings crossings;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) add_segments(road, false, crossings, boxes);
  for (const structures::Span& bridge : bridges) add_segments(bridge, true, crossings, boxes);
  crossings.grid = grid_of(boxes, kCrossingBucket_m);
  return crossings;
}

std::vector<Crossing> crossings_of(const Crossings& crossings, Vec2 a, Vec2 b) {
  std::vector<Crossing> found;
  for (const std::uint32_t i : boxes_about(crossings.grid, box_of_segment(a, b))) {
    const Crossings::Segment& segment = crossings.segments[i];
    const auto shares = crossing_shares(a, b, segment.a, segment.b);
    if (!shares) continue;
    Crossing crossing{shares->first, {}};
    if (segment.a_m) crossing.deck_m = *segment.a_m + (*segment.b_m - *segment.a_m) * shares->second;
    found.push_back(crossing);
  }
  return found;
}

}  // namespace citykiln::wires
