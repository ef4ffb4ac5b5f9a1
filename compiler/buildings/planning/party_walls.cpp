#include "compiler/buildings/planning/party_walls.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <tuple>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/snap.h"

namespace citykiln::buildings {
namespace {

// Shorter overlaps are corners that touch.
constexpr double kMinLength_m = 0.25;
constexpr double kPartyWallBucket_m = 32;
// Cosine of the smallest angle between opposite walls: 3.6 degrees short of 180.
constexpr double kOpposite = -0.998;

struct Edge {
  std::uint32_t footprint, edge;
  bool is_outer;
  Vec2 from, to;
};

void add_edges(std::vector<Edge>& edges, std::uint32_t footprint, const Ring& ring, bool is_outer) {
  for (std::uint32_t i = 0; i < ring.size(); ++i)
    edges.push_back({footprint, i, is_outer, ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Edge> footprint_edges(std::span<const map::Footprint> footprints) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    if (footprints[i].has_parts || footprints[i].polygon.outer.size() < 3) continue;
    add_edges(edges, i, footprints[i].polygon.outer, true);
    for (const Ring& hole : footprints[i].polygon.holes) add_edges(edges, i, hole, false);
  }
  return edges;
}

// The part of `wall` along which `other` runs in the opposite direction.
std::optional<SharedWall> shared(const Edge& wall, const Edge& other) {
  assert(wall.footprint != other.footprint);
  const double length_m = distance(wall.from, wall.to);
  if (length_m < kMinLength_m) return std::nullopt;
  const Vec2 along = (wall.to - wall.from) * (1 / length_m), against = unit(other.to - other.from);
  if (dot(along, against) > kOpposite) return std::nullopt;
  const double from_m = std::max(0.0, dot(along, other.to - wall.from));
  const double to_m = std::min(length_m, dot(along, other.from - wall.from));
  if (to_m - from_m < kMinLength_m) return std::nullopt;
  const auto gap_m = [&](double at_m) { return std::abs(cross(against, wall.from + along * at_m - other.from)); };
  const double largest_gap_m = std::max(gap_m(from_m), gap_m(to_m));
  if (largest_gap_m > kTouching_m) return std::nullopt;
  return SharedWall{.edge = wall.edge,
                    .from_m = snapped(from_m),
                    .to_m = snapped(to_m),
                    .neighbour = other.footprint,
                    .is_coplanar = largest_gap_m <= kCoplanar_m};
}

}  // namespace

std::vector<std::vector<SharedWall>> shared_walls(std::span<const map::Footprint> footprints) {
  const std::vector<Edge> edges = footprint_edges(footprints);
  std::vector<Box2> boxes;
  for (const Edge& edge : edges) boxes.push_back(box_of_segment(edge.from, edge.to).widened(kTouching_m));
  const BoxGrid grid = grid_of(boxes, kPartyWallBucket_m);
  std::vector<std::vector<SharedWall>> all(footprints.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].is_outer) continue;
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      if (edges[j].footprint == edges[i].footprint || !boxes[i].touches(boxes[j])) continue;
      if (const auto wall = shared(edges[i], edges[j])) all[edges[i].footprint].push_back(*wall);
    }
  }
  for (std::vector<SharedWall>& walls : all)
    std::ranges::sort(walls, {}, [&](const SharedWall& wall) {
      return std::tuple(wall.edge, wall.from_m, wall.to_m, footprints[wall.neighbour].id);
    });
  return all;
}

}  // namespace citykiln::buildings
