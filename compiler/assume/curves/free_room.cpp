#include "compiler/assume/curves/free_room.h"

#include <algorithm>
#include <limits>

#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

double distance_of_segments(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (crossing_shares(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, b, c), distance_to_segment(a, b, d), distance_to_segment(c, d, a),
                   distance_to_segment(c, d, b)});
}

double distance_from_ring(const Ring& ring, const Polyline& line) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < ring.size(); ++r)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      least_m = std::min(least_m, distance_of_segments(ring[r], ring[(r + 1) % ring.size()], line[i], line[i + 1]));
  return least_m;
}

}  // namespace

Walls walls_of(std::span<const map::Footprint> footprints) {
  Walls walls;
  std::vector<Box2> boxes;
  for (const map::Footprint& footprint : footprints)
    if (!footprint.is_part && !footprint.polygon.outer.empty())
      walls.footprints.push_back(&footprint), boxes.push_back(box_of(footprint.polygon.outer));
  walls.grid = grid_of(boxes, 32);
  return walls;
}

bool is_in_town(const Walls& walls, Vec2 a, Vec2 b) {
  const Box2 near = box_of_segment(a, b).widened(kInTown_m);
  return any_about(walls.grid, near,
                   [&](std::uint32_t i) { return box_of(walls.footprints[i]->polygon.outer).touches(near); });
}

bool has_room_between(const Walls& walls, const Polyline& curve, double half_m) {
  // the strips of chord and curve differ by less than is seen
  constexpr double kSame_m = 0.05;
  const Polyline chord = {curve.front(), curve.back()};
  return std::ranges::all_of(boxes_about(walls.grid, box_of(curve).widened(half_m)), [&](std::uint32_t i) {
    const Ring& ring = walls.footprints[i]->polygon.outer;
    const double curve_m = distance_from_ring(ring, curve);
    return curve_m >= half_m || curve_m >= distance_from_ring(ring, chord) - kSame_m;
  });
}

}  // namespace citykiln::assume
