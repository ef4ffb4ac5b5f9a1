#include "compiler/buildings/street_sides.h"

#include <algorithm>

namespace citykiln::buildings {
namespace {

constexpr double kBucket_m = 64;
// From a wall to the kerb: a pavement and a front garden.
constexpr double kGarden_m = 14;
constexpr double kWidest_m = 24;
// Shorter walls are corners and reveals.
constexpr double kShortest_m = 1.5;
constexpr double kCos45 = 0.7071;

bool is_street(const map::Track& track) {
  return map::values_of(track.surface).group == map::LandCoverGroup::kRoad && !track.is_rail &&
         track.passage == map::Passage::kGround;
}

Vec2 nearest_on(const Streets::Segment& segment, Vec2 p) {
  const Vec2 along = segment.to - segment.from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - segment.from, along) / squared, 0.0, 1.0) : 0;
  return segment.from + along * t;
}

bool looks_at(Vec2 middle, Vec2 outward, const Streets::Segment& segment) {
  const Vec2 way = nearest_on(segment, middle) - middle;
  const double away_m = length(way);
  return away_m <= segment.half_width_m + kGarden_m && dot(way, outward) >= kCos45 * away_m;
}

bool looks_at_any(Vec2 middle, Vec2 outward, const Streets& streets) {
  Box2 near;
  near.grow(middle);
  for (const std::uint32_t i : boxes_about(streets.grid, near.widened(kWidest_m / 2 + kGarden_m)))
    if (looks_at(middle, outward, streets.segments[i])) return true;
  return false;
}

}  // namespace

Streets index_streets(std::span<const map::Track> tracks) {
  Streets streets;
  std::vector<Box2> boxes;
  for (const map::Track& track : tracks) {
    if (!is_street(track)) continue;
    const double half_m = std::min(kWidest_m, map::carriageway_width_m(track.section)) / 2;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      streets.segments.push_back({track.axis[i], track.axis[i + 1], half_m});
      boxes.emplace_back();
      boxes.back().grow(track.axis[i]);
      boxes.back().grow(track.axis[i + 1]);
    }
  }
  streets.grid = grid_of(boxes, kBucket_m);
  return streets;
}

std::vector<bool> street_sides(const Polygon& footprint, const Streets& streets) {
  const Ring& ring = footprint.outer;
  std::vector<bool> sides(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (length(along) < kShortest_m) continue;
    sides[i] = looks_at_any(ring[i] + along * 0.5, unit(left_of(along)) * -1, streets);
  }
  return sides;
}

}  // namespace citykiln::buildings
