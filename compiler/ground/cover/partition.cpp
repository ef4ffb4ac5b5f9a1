#include "compiler/ground/cover/partition.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/tolerance.h"
#include "compiler/ground/cover/label_faces.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::ground {
namespace {

std::vector<OwnedSegment> segments_of(const NearbyCover& layers) {
  std::vector<OwnedSegment> segments;
  for (std::uint32_t owner = 0; owner < layers.order.size(); ++owner)
    for (const Ring& ring : layers.surfaces[layers.order[owner]].rings)
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        segments.push_back({grid_point(ring[j]), grid_point(ring[i]), owner, 1});
  return segments;
}

std::vector<WindingStep> windings_at(const NearbyCover& layers, Vec2 p) {
  std::vector<WindingStep> windings;
  for (std::uint32_t owner = 0; owner < layers.order.size(); ++owner) {
    const int winding = winding_number(layers.surfaces[layers.order[owner]], p);
    if (winding != 0) windings.push_back({owner, winding});
  }
  return windings;
}

Delaunay triangulate_arrangement(const Arrangement& arrangement) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.emplace_back(e.a, e.b);
  return Delaunay(arrangement.vertices, edges);
}

// Returns the face with the largest inscribed circle: rounding has moved no border across its centre, so the original
// rings give its winding numbers.
LabelledFace known_face(const Delaunay& triangulation, const NearbyCover& layers) {
  const WidestFace widest = widest_face(triangulation);
  return {widest.face, windings_at(layers, {widest.x * kQuantum_m, widest.y * kQuantum_m})};
}

// Owners are ranked as they are numbered.
std::vector<std::uint32_t> ranks_of(std::size_t owners) {
  std::vector<std::uint32_t> ranks(owners);
  for (std::uint32_t i = 0; i < ranks.size(); ++i) ranks[i] = i;
  return ranks;
}

// Returns the polygons beside the borders, sorted: their places in this list are the owners of the partition's edges.
std::vector<std::uint32_t> surfaces_beside(std::span<const Border> borders) {
  std::vector<std::uint32_t> surfaces;
  for (const Border& border : borders) surfaces.insert(surfaces.end(), {border.left, border.right});
  sort_unique(surfaces);
  return surfaces;
}

std::uint32_t place_in(const std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

// Returns the face with an outer edge (from, to) for which is_it is true; kNoFace without.
template <typename IsIt>
std::uint32_t outer_face(const Delaunay& net, IsIt is_it) {
  for (std::uint32_t f = 0; f < net.faces().size(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (net.faces()[f].neighbours[i] != kNoFace) continue;
      if (const auto [from, to] = edge_of(net, f, i); is_it(from, to)) return f;
    }
  return kNoFace;
}

// Returns the polygon at the southern side of the cell's south-west corner, from the border piece there.
std::uint32_t corner_surface(std::span<const Border> borders, GridPoint corner) {
  const auto at_corner = [&](const Border& b) { return b.is_cell_border && b.a == corner && b.b.y == corner.y; };
  const auto found = std::ranges::find_if(borders, at_corner);
  return found == borders.end() ? kNoLandCover : found->left;
}

// Rounding may move where a ring meets the border by this many grid steps.
constexpr std::int64_t kNearSteps = 4;

bool is_near(std::span<const GridPoint> joints, GridPoint p) {
  return std::ranges::any_of(joints, [&](GridPoint joint) {
    return std::abs(joint.x - p.x) <= kNearSteps && std::abs(joint.y - p.y) <= kNearSteps;
  });
}

// Returns whether the segment's box touches the border or comes within kNearSteps of it.
bool comes_near_border(GridPoint a, GridPoint b, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  const auto [low_x, high_x] = std::minmax(a.x, b.x);
  const auto [low_y, high_y] = std::minmax(a.y, b.y);
  return low_x < min.x + kNearSteps || high_x > max.x - kNearSteps || low_y < min.y + kNearSteps ||
         high_y > max.y - kNearSteps;
}

bool is_on_rim(GridPoint a, GridPoint b, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  return (a.x == b.x && (a.x == min.x || a.x == max.x)) || (a.y == b.y && (a.y == min.y || a.y == max.y));
}

// Returns a strip beyond the cell's border, a metre wide, that reaches past both ends of an edge there.
Box2 strip_beyond(GridPoint a, GridPoint b, const Box2& cell) {
  const Vec2 low = plane_point(a), high = plane_point(b);
  const Vec2 min{std::floor(low.x) - 1, std::floor(low.y) - 1}, max{std::ceil(high.x) + 1, std::ceil(high.y) + 1};
  if (low.x == high.x)
    return low.x == cell.min.x ? Box2{{low.x - 1, min.y}, {low.x, max.y}} : Box2{{low.x, min.y}, {low.x + 1, max.y}};
  return low.y == cell.min.y ? Box2{{min.x, low.y - 1}, {max.x, low.y}} : Box2{{min.x, low.y}, {max.x, low.y + 1}};
}

// Joins pieces of the cell's border except where a vertex must stay between them.
template <typename Stays>
std::vector<Border> joined_cell_border(std::vector<Border> cell_border, Stays stays) {
  const auto line = [](const Border& b) { return b.a.x == b.b.x ? std::pair(0, b.a.x) : std::pair(1, b.a.y); };
  std::ranges::sort(cell_border, {}, [&](const Border& b) { return std::pair(line(b), b.a); });
  std::vector<Border> joined;
  for (const Border& piece : cell_border) {
    const bool goes_on = !joined.empty() && line(joined.back()) == line(piece) && joined.back().b == piece.a &&
                         joined.back().left == piece.left && !stays(piece.a);
    if (goes_on)
      joined.back().b = piece.b;
    else
      joined.push_back(piece);
  }
  return joined;
}

}  // namespace

NearbyCover land_cover_near(std::span<const LandCoverPolygon> surfaces, const Box2& cell) {
  NearbyCover layers{surfaces, {}};
  // a ring that ends a grid step outside may still be rounded onto the border
  const Box2 reach = cell.widened(kQuantum_m);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    const auto& rings = surfaces[i].rings;
    if (std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) { return box_of(ring).touches(reach); }))
      layers.order.push_back(i);
  }
  std::sort(layers.order.begin(), layers.order.end(), [&](auto a, auto b) { return covers(surfaces[a], surfaces[b]); });
  return layers;
}

Partition partition_all_rings(const NearbyCover& layers, std::span<const std::pair<GridPoint, GridPoint>> lines,
                              std::span<const GridPoint> points, const Box2& cell) {
  std::vector<OwnedSegment> segments = segments_of(layers);
  // lines share an owner below all others, so that none of them is dropped
  const auto line_owner = static_cast<std::uint32_t>(layers.order.size());
  for (const auto& [a, b] : lines) segments.push_back({a, b, line_owner, 1});
  Arrangement arrangement = arrange(segments, points, cell);
  Delaunay triangulation = triangulate_arrangement(arrangement);
  const LabelledFace known = known_face(triangulation, layers);
  std::vector<std::uint32_t> top = label_faces(triangulation, arrangement, known, ranks_of(line_owner + 1));
  for (std::uint32_t& owner : top) owner = owner >= line_owner ? kNoLandCover : layers.order[owner];
  return {std::move(arrangement), std::move(triangulation), std::move(top)};
}

std::vector<GridPoint> ring_joints(const NearbyCover& layers, const Arrangement& all, const Box2& cell) {
  assert(!cell.is_empty());
  std::vector<OwnedSegment> segments = segments_of(layers);
  std::erase_if(segments, [&](const OwnedSegment& s) { return !comes_near_border(s.a, s.b, cell); });
  std::vector<GridPoint> joints = arrange(segments, {}, cell).vertices;
  const auto is_passed = [&](GridPoint p) {
    return std::ranges::any_of(segments, [&](const OwnedSegment& s) { return passes(s, p); });
  };
  for (const GridPoint p : all.vertices)
    if (is_on_border(p, cell) && is_passed(p)) joints.push_back(p);
  std::erase_if(joints, [&](GridPoint p) { return !is_on_border(p, cell); });
  sort_unique(joints);
  return joints;
}

std::vector<CellBorderPiece> cell_border_pieces(const NearbyCover& layers,
                                                std::span<const std::pair<GridPoint, GridPoint>> lines,
                                                std::span<const GridPoint> points, const Arrangement& all,
                                                const Box2& cell) {
  std::vector<CellBorderPiece> pieces;
  // the strip needs the cell's vertices: the cell's corners, for one, are no places of its own
  std::vector<GridPoint> places(points.begin(), points.end());
  std::ranges::copy_if(all.vertices, std::back_inserter(places), [&](GridPoint p) { return is_on_border(p, cell); });
  for (const ArrangedEdge& edge : all.edges) {
    const GridPoint a = all.vertices[edge.a], b = all.vertices[edge.b];
    const auto steps = std::span(all.steps).subspan(edge.first, edge.count);
    // lines have the last owner
    const auto is_of_ring = [&](const WindingStep& step) { return step.owner < layers.order.size(); };
    if (!is_on_rim(a, b, cell) || std::ranges::none_of(steps, is_of_ring)) continue;
    const Partition strip = partition_all_rings(layers, lines, places, strip_beyond(a, b, cell));
    const std::uint32_t face = outer_face(
        strip.triangulation, [&](GridPoint p, GridPoint q) { return std::minmax(p, q) == std::minmax(a, b); });
    if (face != kNoFace) pieces.push_back({a, b, strip.face_cover[face]});
  }
  return pieces;
}

std::vector<Border> empty_cell_borders(const Box2& cell) {
  const GridPoint sw = grid_point(cell.min), ne = grid_point(cell.max), se{ne.x, sw.y}, nw{sw.x, ne.y};
  const auto side = [](GridPoint a, GridPoint b) { return Border{a, b, kNoLandCover, kNoLandCover, true}; };
  return {side(sw, se), side(sw, nw), side(se, ne), side(nw, ne)};
}

std::vector<Border> visible_borders(const Partition& all, std::span<const GridPoint> joints) {
  std::vector<Border> borders, cell_border;
  const auto& faces = all.triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = faces[f].neighbours[i];
      if (!faces[f].is_constrained[i]) continue;
      const auto [a, b] = edge_of(all.triangulation, f, i);
      const std::uint32_t left = all.face_cover[f];
      if (beyond == kNoFace) cell_border.push_back({std::min(a, b), std::max(a, b), left, left, true});
      // an inner edge is seen from both sides; the side that sees it from its lower end counts
      else if (a < b && left != all.face_cover[beyond])
        borders.push_back({a, b, left, all.face_cover[beyond], false});
    }
  const std::vector<GridPoint> kept = ends_of(borders);
  const auto stays = [&](GridPoint p) { return std::ranges::binary_search(kept, p) || is_near(joints, p); };
  const std::vector<Border> joined = joined_cell_border(std::move(cell_border), stays);
  borders.insert(borders.end(), joined.begin(), joined.end());
  return borders;
}

std::optional<Partition> partition_of_borders(std::span<const Border> borders, std::span<const GridPoint> points,
                                              const Box2& cell, std::span<const std::pair<GridPoint, GridPoint>> lines,
                                              Rounding rounding) {
  assert(std::ranges::any_of(borders, &Border::is_cell_border));
  const std::vector<std::uint32_t> surfaces = surfaces_beside(borders);
  std::vector<OwnedSegment> segments;
  for (const Border& border : borders) {
    if (border.is_cell_border) continue;
    segments.push_back({border.a, border.b, place_in(surfaces, border.left), 1});
    segments.push_back({border.a, border.b, place_in(surfaces, border.right), -1});
  }
  // lines share an owner below all others
  const auto line_owner = static_cast<std::uint32_t>(surfaces.size());
  for (const auto& [a, b] : lines) segments.push_back({a, b, line_owner, 1});
  std::optional<Arrangement> arrangement =
      rounding == Rounding::kNone ? arrange_exactly(segments, points, cell) : arrange_inside(segments, points, cell);
  if (!arrangement) return std::nullopt;
  Delaunay triangulation = triangulate_arrangement(*arrangement);
  const GridPoint corner = grid_point(cell.min);
  const std::uint32_t corner_face =
      outer_face(triangulation, [&](GridPoint from, GridPoint to) { return from == corner && to.y == corner.y; });
  const LabelledFace known{corner_face, {{place_in(surfaces, corner_surface(borders, corner)), 1}}};
  std::vector<std::uint32_t> top = label_faces(triangulation, *arrangement, known, ranks_of(line_owner + 1));
  for (std::uint32_t& owner : top) owner = owner >= line_owner ? kNoLandCover : surfaces[owner];
  return Partition{std::move(*arrangement), std::move(triangulation), std::move(top)};
}

}  // namespace citykiln::ground
