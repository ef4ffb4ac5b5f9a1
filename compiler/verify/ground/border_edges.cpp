#include "compiler/verify/ground/border_edges.h"

#include <algorithm>
#include <iterator>

#include "compiler/verify/ground/measure_ground.h"

namespace citykiln::verify {
namespace {

/// Edges with both ends at the coordinate.
template <typename Coordinate>
BorderEdges border_edges(const bake::BakedTile& tile, double at, Coordinate coordinate) {
  BorderEdges edges;
  for_each_ground_face(tile, [&](const GroundFace& face) {
    const std::array<Vec3, 3>& t = face.corners;
    const bool is_upright = twice_area(in_plan(t[0]), in_plan(t[1]), in_plan(t[2])) <= 0;
    std::vector<BorderEdge>& kind = is_upright ? edges.vertical : edges.ground;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = t[i], b = t[(i + 1) % 3];
      if (coordinate(a) != at || coordinate(b) != at || in_plan(a) == in_plan(b)) continue;
      kind.push_back(a < b ? BorderEdge{a, b} : BorderEdge{b, a});
    }
  });
  std::ranges::sort(edges.ground);
  std::ranges::sort(edges.vertical);
  return edges;
}

std::vector<BorderEdge> only_in(const std::vector<BorderEdge>& own, const std::vector<BorderEdge>& other) {
  std::vector<BorderEdge> only;
  std::ranges::set_difference(own, other, std::back_inserter(only));
  return only;
}

bool are_above_each_other(const BorderEdge& one, const BorderEdge& other) {
  return in_plan(one[0]) == in_plan(other[0]) && in_plan(one[1]) == in_plan(other[1]);
}

}  // namespace

BorderEdges border_edges_at_x(const bake::BakedTile& tile, double at) {
  return border_edges(tile, at, [](Vec3 p) { return p.x; });
}

BorderEdges border_edges_at_y(const bake::BakedTile& tile, double at) {
  return border_edges(tile, at, [](Vec3 p) { return p.y; });
}

bool borders_match(const BorderEdges& own, const BorderEdges& other) {
  // both lists are sorted, and a tile has each edge once
  const std::vector<BorderEdge> here = only_in(own.ground, other.ground), there = only_in(other.ground, own.ground);
  return std::ranges::equal(here, there, [&](const BorderEdge& a, const BorderEdge& b) {
    return are_above_each_other(a, b) &&
           (std::ranges::binary_search(own.vertical, b) || std::ranges::binary_search(other.vertical, a));
  });
}

}  // namespace citykiln::verify
