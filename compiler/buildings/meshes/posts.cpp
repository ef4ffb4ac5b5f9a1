#include "compiler/buildings/meshes/posts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::buildings {
namespace {

constexpr double kPostBucket_m = 32;
// Beside a way, and from a wall that carries the building instead.
constexpr double kBesideWay_m = 0.25, kBesideWall_m = 0.25;
// Posts nearer to each other than this many widths are one.
constexpr double kLeastWidthsApart = 3;

void add_ways(const map::Track& track, PostObstacles& obstacles, std::vector<Box2>& boxes) {
  const double carriageway_m = map::carriageway_width_m(track.section), total_m = map::total_width_m(track.section);
  // raised lanes may all lie on one side
  const double raised_m = total_m - carriageway_m, offset_m = track.section.axis_offset_m;
  const double clear_m = std::max(offset_m, carriageway_m - offset_m) + raised_m + kBesideWay_m;
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
    obstacles.ways.push_back({track.axis[i], track.axis[i + 1], clear_m});
    boxes.push_back(box_of_segment(track.axis[i], track.axis[i + 1]).widened(clear_m));
  }
}

bool has_walls(const map::Footprint& f) {
  return !f.has_parts && !f.is_open && f.min_height_m == 0 && f.polygon.outer.size() >= 3;
}

// Points on the border with the inward direction to their post: corners, and places between.
struct BorderPlace {
  Vec2 at, inward;
};

void add_places(const Ring& ring, std::vector<BorderPlace>& places) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = ring[(i + n - 1) % n], at = ring[i], after = ring[(i + 1) % n];
    if (at == after || at == before) continue;
    const Vec2 in = left_of(unit(at - before)), out = left_of(unit(after - at)), both = in + out;
    // a corner's post is a width away from both edges, up to twice that from a sharp corner
    if (dot(both, both) > 0.25) places.push_back({at, both * (2 / dot(both, both))});
    const double edge_m = distance(at, after), count = std::ceil(edge_m / kMostPostSpacing_m);
    for (double k = 1; k < count; ++k) places.push_back({at + (after - at) * (k / count), out});
  }
}

double distance_to_border_m(const Polygon& polygon, Vec2 p) {
  double least_m = distance_to_ring(polygon.outer, p);
  for (const Ring& hole : polygon.holes) least_m = std::min(least_m, distance_to_ring(hole, p));
  return least_m;
}

bool is_on_way(Vec2 p, const PostObstacles& obstacles, double width_m) {
  return std::ranges::any_of(boxes_about(obstacles.way_grid, Box2{p, p}.widened(width_m)), [&](std::uint32_t i) {
    const PostObstacles::Way& way = obstacles.ways[i];
    return distance_to_segment(way.from, way.to, p) < way.clear_m + width_m;
  });
}

bool is_at_wall(Vec2 p, std::size_t self, const PostObstacles& obstacles, double width_m) {
  const double clear_m = width_m + kBesideWall_m;
  const auto near = boxes_about(obstacles.walled_grid, Box2{p, p}.widened(clear_m));
  return std::ranges::any_of(near, [&](std::uint32_t i) {
    const std::uint32_t other = obstacles.walled[i];
    if (other == self) return false;
    const Polygon& polygon = obstacles.footprints[other].polygon;
    return contains(polygon, p) || distance_to_border_m(polygon, p) < clear_m;
  });
}

}  // namespace

PostObstacles index_post_obstacles(std::span<const map::Track> tracks, std::span<const map::Footprint> footprints) {
  PostObstacles obstacles;
  std::vector<Box2> boxes;
  for (const map::Track& track : tracks)
    if (track.passage != map::Passage::kTunnel) add_ways(track, obstacles, boxes);
  obstacles.way_grid = grid_of(boxes, kPostBucket_m);
  obstacles.footprints = footprints;
  boxes.clear();
  for (std::uint32_t i = 0; i < footprints.size(); ++i)
    if (has_walls(footprints[i])) obstacles.walled.push_back(i), boxes.push_back(box_of(footprints[i].polygon.outer));
  obstacles.walled_grid = grid_of(boxes, kPostBucket_m);
  return obstacles;
}

std::vector<Vec2> plan_posts(std::size_t footprint, const PostObstacles& obstacles, double height_m) {
  const Polygon& polygon = obstacles.footprints[footprint].polygon;
  const double width_m = post_width_m(height_m);
  std::vector<BorderPlace> places;
  for (const Ring* ring : rings_of(polygon)) add_places(*ring, places);
  std::vector<Vec2> posts;
  for (const BorderPlace& place : places) {
    const Vec2 p = snapped_to(map::kMapStep_m, place.at + place.inward * width_m);
    if (!contains(polygon, p) || distance_to_border_m(polygon, p) < width_m / 2) continue;
    if (is_on_way(p, obstacles, width_m) || is_at_wall(p, footprint, obstacles, width_m)) continue;
    const auto touches = [&](Vec2 other) { return distance(p, other) < kLeastWidthsApart * width_m; };
    if (std::ranges::none_of(posts, touches)) posts.push_back(p);
  }
  return posts;
}

double post_width_m(double height_m) { return std::clamp(snapped(height_m / 30), 0.125, 0.75); }

std::vector<grammars::Face> post_faces(const Building& building) {
  const double half_m = post_width_m(building.bottom_m - building.post_foot_m) / 2;
  constexpr std::array<Vec2, 4> kCorners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
  std::vector<grammars::Face> faces;
  for (const Vec2 post : building.posts)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 a = post + kCorners[i] * half_m, b = post + kCorners[(i + 1) % 4] * half_m;
      grammars::Face& face = faces.emplace_back();
      face.outer = {at_height(a, building.post_foot_m), at_height(b, building.post_foot_m),
                    at_height(b, building.bottom_m), at_height(a, building.bottom_m)};
    }
  return faces;
}

}  // namespace citykiln::buildings
