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

double distance_from_piece(Vec2 a, Vec2 b, const Polyline& line) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least_m = std::min(least_m, distance_of_segments(a, b, line[i], line[i + 1]));
  return least_m;
}

// The distance of the farther edge of a way from its axis, pavements included.
double edge_m(const map::Track& track) {
  return map::total_width_m(track.section) -
         std::min(map::left_kerb_m(track.section), map::right_kerb_m(track.section));
}

/// The strips of chord and curve differ by less than is seen.
constexpr double kSameStrip_m = 0.05;

}  // namespace

BuildingOutlines building_outlines(std::span<const map::Footprint> footprints) {
  BuildingOutlines walls;
  std::vector<Box2> boxes;
  for (const map::Footprint& footprint : footprints)
    if (!footprint.is_part && !footprint.polygon.outer.empty())
      walls.footprints.push_back(&footprint), boxes.push_back(box_of(footprint.polygon.outer));
  walls.grid = grid_of(boxes, 32);
  return walls;
}

bool is_in_town(const BuildingOutlines& walls, Vec2 a, Vec2 b) {
  const Box2 near = box_of_segment(a, b).widened(kInTown_m);
  return any_about(walls.grid, near,
                   [&](std::uint32_t i) { return box_of(walls.footprints[i]->polygon.outer).touches(near); });
}

bool has_room_between(const BuildingOutlines& walls, const Polyline& curve, double half_m) {
  const Polyline chord = {curve.front(), curve.back()};
  return std::ranges::all_of(boxes_about(walls.grid, box_of(curve).widened(half_m)), [&](std::uint32_t i) {
    const Ring& ring = walls.footprints[i]->polygon.outer;
    const double curve_m = distance_from_ring(ring, curve);
    return curve_m >= half_m || curve_m >= distance_from_ring(ring, chord) - kSameStrip_m;
  });
}

WayPieces pieces_of_ways(std::span<const map::Track> tracks) {
  WayPieces ways;
  std::vector<Box2> boxes;
  for (const map::Track& track : tracks) {
    if (track.passage != map::Passage::kGround || track.is_indoor) continue;
    ways.widest_m = std::max(ways.widest_m, edge_m(track));
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      ways.pieces.emplace_back(&track, i);
      boxes.push_back(box_of_segment(track.axis[i], track.axis[i + 1]));
    }
  }
  ways.grid = grid_of(boxes, 32);
  return ways;
}

bool keeps_off_other_ways(const WayPieces& ways, const map::Track& track, const Polyline& curve) {
  const double own_m = edge_m(track);
  const Polyline chord = {curve.front(), curve.back()};
  return !any_about(ways.grid, box_of(curve).widened(own_m + ways.widest_m), [&](std::uint32_t i) {
    const map::Track& other = *ways.pieces[i].first;
    if (other.id.osm == track.id.osm || (track.assumed_sides == 0 && other.assumed_sides == 0)) return false;
    const Vec2 a = other.axis[ways.pieces[i].second], b = other.axis[ways.pieces[i].second + 1];
    const double curve_m = distance_from_piece(a, b, curve);
    if (curve_m >= own_m + edge_m(other)) return false;
    const bool meets = a == chord[0] || a == chord[1] || b == chord[0] || b == chord[1];
    return !meets || curve_m < distance_from_piece(a, b, chord) - kSameStrip_m;
  });
}

}  // namespace citykiln::assume
