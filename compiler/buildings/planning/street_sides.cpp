#include "compiler/buildings/planning/street_sides.h"

#include <algorithm>

#include "compiler/geometry/segment.h"

namespace citykiln::buildings {
namespace {

constexpr double kStreetBucket_m = 64;
// From a wall to the kerb: a pavement and a front garden.
constexpr double kMaxGarden_m = 14;
// Wider carriageways count as this wide.
constexpr double kMaxStreet_m = 24;
// Shorter edges are corners and reveals.
constexpr double kMinEdge_m = 1.5;
constexpr double kCos45 = 0.7071;

// A runway counts, too.
bool has_fronts(const map::Track& track) {
  return map::values_of(track.surface).group == map::LandCoverGroup::kRoad && !track.is_rail &&
         track.passage == map::Passage::kGround;
}

bool faces(Vec2 middle, Vec2 outward, const Streets::Segment& segment) {
  const Vec2 way = nearest_point(segment.from, segment.to, middle) - middle;
  const double away_m = length(way);
  return away_m <= segment.half_width_m + kMaxGarden_m && dot(way, outward) >= kCos45 * away_m;
}

}  // namespace

Streets index_streets(std::span<const map::Track> tracks) {
  Streets streets;
  std::vector<Box2> boxes;
  for (const map::Track& track : tracks) {
    if (!has_fronts(track)) continue;
    const double half_m = std::min(kMaxStreet_m, map::carriageway_width_m(track.section)) / 2;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      streets.segments.push_back({track.axis[i], track.axis[i + 1], half_m});
      boxes.push_back(box_of_segment(track.axis[i], track.axis[i + 1]));
    }
  }
  streets.grid = grid_of(boxes, kStreetBucket_m);
  return streets;
}

std::vector<bool> street_sides(const Polygon& footprint, const Streets& streets) {
  const Ring& ring = footprint.outer;
  std::vector<bool> sides(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i], middle = ring[i] + along * 0.5;
    if (length(along) < kMinEdge_m) continue;
    const std::vector<std::uint32_t> near =
        boxes_about(streets.grid, Box2{middle, middle}.widened(kMaxStreet_m / 2 + kMaxGarden_m));
    sides[i] = std::ranges::any_of(
        near, [&](std::uint32_t s) { return faces(middle, unit(left_of(along)) * -1, streets.segments[s]); });
  }
  return sides;
}

}  // namespace citykiln::buildings
