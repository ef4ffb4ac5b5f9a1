#include "compiler/buildings/party_walls.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/snap.h"

namespace citykiln::buildings {
namespace {

// Shorter stretches are a corner that touches.
constexpr double kShortest_m = 0.25;
constexpr double kBucket_m = 32;
// Walls that run within some degrees of each other.
constexpr double kOpposite = -0.998;

struct Edge {
  std::uint32_t footprint, edge;
  bool is_outer;
  Vec2 from, to;
};

Box2 box_of(const Edge& edge) {
  Box2 box;
  box.grow(edge.from);
  box.grow(edge.to);
  return box;
}

void add_edges(std::vector<Edge>& edges, std::uint32_t footprint, const Ring& ring, bool is_outer) {
  for (std::uint32_t i = 0; i < ring.size(); ++i)
    edges.push_back({footprint, i, is_outer, ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Edge> edges_of(std::span<const map::Footprint> footprints) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    if (footprints[i].has_parts || footprints[i].polygon.outer.size() < 3) continue;
    add_edges(edges, i, footprints[i].polygon.outer, true);
    for (const Ring& hole : footprints[i].polygon.holes) add_edges(edges, i, hole, false);
  }
  return edges;
}

// Where `other` runs along `wall`, the other way.
std::optional<SharedWall> shared(const Edge& wall, const Edge& other) {
  const double length_m = distance(wall.from, wall.to);
  if (length_m < kShortest_m) return std::nullopt;
  const Vec2 along = (wall.to - wall.from) * (1 / length_m), against = unit(other.to - other.from);
  if (dot(along, against) > kOpposite) return std::nullopt;
  const double from_m = std::max(0.0, dot(along, other.to - wall.from));
  const double to_m = std::min(length_m, dot(along, other.from - wall.from));
  if (to_m - from_m < kShortest_m) return std::nullopt;
  // how far the other's line is off at both ends of the stretch
  const auto off_m = [&](double at_m) { return std::abs(cross(against, wall.from + along * at_m - other.from)); };
  const double most_m = std::max(off_m(from_m), off_m(to_m));
  if (most_m > kTouching_m) return std::nullopt;
  return SharedWall{wall.edge, snapped(from_m), snapped(to_m), other.footprint, most_m <= kCoplanar_m};
}

}  // namespace

std::vector<std::vector<SharedWall>> shared_walls(std::span<const map::Footprint> footprints) {
  const std::vector<Edge> edges = edges_of(footprints);
  std::vector<Box2> boxes;
  for (const Edge& edge : edges) boxes.push_back(box_of(edge).widened(kTouching_m));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  std::vector<std::vector<SharedWall>> all(footprints.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].is_outer) continue;
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      if (edges[j].footprint == edges[i].footprint || !boxes[i].touches(boxes[j])) continue;
      if (const auto wall = shared(edges[i], edges[j])) all[edges[i].footprint].push_back(*wall);
    }
  }
  for (std::vector<SharedWall>& walls : all)
    std::sort(walls.begin(), walls.end(), [&](const SharedWall& a, const SharedWall& b) {
      return std::tie(a.edge, a.from_m, a.to_m, footprints[a.neighbour].id) <
             std::tie(b.edge, b.from_m, b.to_m, footprints[b.neighbour].id);
    });
  return all;
}

}  // namespace citykiln::buildings
