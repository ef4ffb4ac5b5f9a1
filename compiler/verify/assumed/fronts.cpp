#include <algorithm>

#include "compiler/geometry/segment.h"
#include "compiler/verify/assumed/measure_assumed.h"

namespace citykiln::verify {
namespace {

// Rounding of places along walls.
constexpr double kAlongWall_m = 0.01;
// Rounding of the sides of openings.
constexpr double kInOpening_m = 0.05;
// The spacing of places of a front that are tested against openings.
constexpr double kFrontPlaces_m = 0.5;

bool overlap(double from_m, double to_m, double other_from_m, double other_to_m) {
  return std::min(to_m, other_to_m) - std::max(from_m, other_from_m) > kAlongWall_m;
}

bool is_across_opening(const buildings::Building& building, const buildings::Front& front, Vec2 corner, Vec2 along) {
  const int steps = std::max(1, static_cast<int>((front.to_m - front.from_m) / kFrontPlaces_m));
  return std::ranges::any_of(building.passageways, [&](const buildings::Passageway& opening) {
    const double half_m = std::min(opening.left_m, opening.right_m) - kInOpening_m;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = corner + along * (front.from_m + (front.to_m - front.from_m) * i / steps);
      if (distance_to_polyline(opening.axis, p) < half_m) return true;
    }
    return false;
  });
}

// True if nothing else is on the part of the wall that an assumed front takes.
bool is_on_free_wall(const buildings::Building& building, const buildings::Front& front) {
  const Ring& ring = building.footprint.outer;
  if (front.edge >= ring.size()) return false;
  const Vec2 a = ring[front.edge], b = ring[(front.edge + 1) % ring.size()];
  if (front.from_m < 0 || front.to_m > distance(a, b) + kAlongWall_m || front.from_m >= front.to_m) return false;
  const auto is_taken_by = [&](const auto& other) {
    return other.edge == front.edge && overlap(front.from_m, front.to_m, other.from_m, other.to_m);
  };
  const auto is_taken_by_front = [&](const buildings::Front& other) { return &other != &front && is_taken_by(other); };
  return std::ranges::none_of(building.party_walls, is_taken_by) &&
         std::ranges::none_of(building.fronts, is_taken_by_front) &&
         !is_across_opening(building, front, a, unit(b - a));
}

}  // namespace

AssumedTests measure_assumed_fronts(const scene::Chunk& chunk) {
  AssumedTests found;
  for (const buildings::Building& building : chunk.buildings)
    for (const buildings::Front& front : building.fronts) {
      if (!front.is_assumed) continue;
      ++found.tested;
      if (is_on_free_wall(building, front)) continue;
      if (found.conflicts++ == 0)
        found.at = building.footprint.outer[front.edge % building.footprint.outer.size()],
        found.element = building.id.osm;
    }
  return found;
}

}  // namespace citykiln::verify
