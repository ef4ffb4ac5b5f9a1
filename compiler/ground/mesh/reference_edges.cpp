#include "compiler/ground/mesh/reference_edges.h"

#include <algorithm>
#include <cassert>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/cover/border.h"

namespace citykiln::ground {
namespace {

using Corners = std::array<GridPoint, 3>;
using Line = std::pair<GridPoint, GridPoint>;

// Returns whether the line along an edge of one separates it from the other; triangles that touch are separate.
bool is_separated(const Corners& one, const Corners& other) {
  for (int i = 0; i < 3; ++i) {
    const auto is_beyond = [&](GridPoint p) { return turn(one[i], one[(i + 1) % 3], p) <= 0; };
    if (std::ranges::all_of(other, is_beyond)) return true;
  }
  return false;
}

bool overlap(const Corners& one, const Corners& other) {
  const auto [west, east] = std::minmax({one[0].x, one[1].x, one[2].x});
  const auto [other_west, other_east] = std::minmax({other[0].x, other[1].x, other[2].x});
  if (east <= other_west || other_east <= west) return false;
  return !is_separated(one, other) && !is_separated(other, one);
}

// Returns where an edge towards `other` starts: at its end, or before it on a border that must get no vertex there.
GridPoint start_of(GridPoint end, GridPoint other, const Box2& cell, std::span<const GridPoint> kept) {
  if (!is_on_border(end, cell) || std::ranges::binary_search(kept, end)) return end;
  const Vec2 from = plane_point(end), to = plane_point(other);
  return grid_point(from + (to - from) * (kFromBorder_m / distance(from, to)));
}

// Adds an edge, shortened where it may not reach the border; left out if nothing remains, or if the grid moves the
// shortened end back onto the border.
void add_shortened_edge(GridPoint a, GridPoint b, const Box2& cell, std::span<const GridPoint> kept,
                        std::vector<Line>& edges) {
  const GridPoint from = start_of(a, b, cell, kept), to = start_of(b, a, cell, kept);
  const bool is_long = distance(plane_point(a), plane_point(b)) > 3 * kFromBorder_m;
  const auto is_good = [&](GridPoint end, GridPoint start) {
    return start == end || (is_long && !is_on_border(start, cell));
  };
  if (is_good(a, from) && is_good(b, to)) edges.push_back(std::minmax(from, to));
}

}  // namespace

std::vector<Line> edges_about(const Reference& reference, std::span<const Corners> triangles,
                              std::span<const GridPoint> kept) {
  assert(std::ranges::is_sorted(kept));
  std::vector<Line> edges;
  if (reference.terrain != nullptr) return edges;
  const auto& vertices = reference.triangulation.vertices();
  for (const DelaunayFace& face : reference.triangulation.faces()) {
    const Corners corners{vertices[face.vertices[0]], vertices[face.vertices[1]], vertices[face.vertices[2]]};
    if (std::ranges::none_of(triangles, [&](const Corners& triangle) { return overlap(corners, triangle); })) continue;
    for (int i = 0; i < 3; ++i)
      if (face.neighbours[i] != kNoFace)
        add_shortened_edge(corners[(i + 1) % 3], corners[(i + 2) % 3], reference.cell, kept, edges);
  }
  sort_unique(edges);
  return edges;
}

std::vector<GridPoint> points_on_border(std::span<const GridPoint> points, const Box2& cell) {
  std::vector<GridPoint> found;
  std::ranges::copy_if(points, std::back_inserter(found), [&](GridPoint p) { return is_on_border(p, cell); });
  std::ranges::sort(found);
  return found;
}

}  // namespace citykiln::ground
