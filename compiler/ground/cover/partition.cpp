#include "compiler/ground/cover/partition.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
    int winding = 0;
    for (const Ring& ring : layers.surfaces[layers.order[owner]].rings) winding += winding_number(ring, p);
    if (winding != 0) windings.push_back({owner, winding});
  }
  return windings;
}

Delaunay triangulated(const Arrangement& arrangement) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.emplace_back(e.a, e.b);
  return Delaunay(arrangement.vertices, edges);
}

// The face whose circle is widest, so that no rounding has moved a border across its centre. Owners as in the layers.
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

// What is seen, sorted: the owners of a partition's borders are their places in this list.
std::vector<std::uint32_t> surfaces_beside(std::span<const Border> borders) {
  std::vector<std::uint32_t> surfaces;
  for (const Border& border : borders) surfaces.insert(surfaces.end(), {border.left, border.right});
  std::ranges::sort(surfaces);
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

std::uint32_t place_in(const std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

// The face at the cell's south-western corner that has its southern side: what covers it tells the border piece there.
std::uint32_t corner_face(const Delaunay& triangulation, GridPoint corner) {
  const auto& vertices = triangulation.vertices();
  const auto& faces = triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const GridPoint a = vertices[faces[f].vertices[(i + 1) % 3]], b = vertices[faces[f].vertices[(i + 2) % 3]];
      if (faces[f].neighbours[i] == kNoFace && a == corner && b.y == corner.y) return f;
    }
  return 0;
}

std::uint32_t corner_surface(std::span<const Border> borders, GridPoint corner) {
  const auto at_corner = [&](const Border& b) { return b.is_cell_border && b.a == corner && b.b.y == corner.y; };
  const auto found = std::ranges::find_if(borders, at_corner);
  return found == borders.end() ? kNoLandCover : found->left;
}

// Rounding may carry what meets the border so many grid steps along it.
constexpr std::int64_t kNearSteps = 4;

bool is_near(std::span<const GridPoint> joints, GridPoint p) {
  return std::ranges::any_of(joints, [&](GridPoint joint) {
    return std::abs(joint.x - p.x) <= kNearSteps && std::abs(joint.y - p.y) <= kNearSteps;
  });
}

bool is_on_border(GridPoint p, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  return p.x == min.x || p.x == max.x || p.y == min.y || p.y == max.y;
}

// Boxes that touch the border, or come within some grid steps of it.
bool comes_near_border(GridPoint a, GridPoint b, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  const auto [low_x, high_x] = std::minmax(a.x, b.x);
  const auto [low_y, high_y] = std::minmax(a.y, b.y);
  return low_x < min.x + kNearSteps || high_x > max.x - kNearSteps || low_y < min.y + kNearSteps ||
         high_y > max.y - kNearSteps;
}

std::vector<GridPoint> ends_of(std::span<const Border> borders) {
  std::vector<GridPoint> ends;
  for (const Border& border : borders) ends.insert(ends.end(), {border.a, border.b});
  std::ranges::sort(ends);
  return ends;
}

bool is_on_rim(GridPoint a, GridPoint b, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  return (a.x == b.x && (a.x == min.x || a.x == max.x)) || (a.y == b.y && (a.y == min.y || a.y == max.y));
}

// A strip beyond the cell's border, a metre wide, and farther than an edge there at both ends.
Box2 beyond(GridPoint a, GridPoint b, const Box2& cell) {
  const Vec2 low = plane_point(a), high = plane_point(b);
  const Vec2 min{std::floor(low.x) - 1, std::floor(low.y) - 1}, max{std::ceil(high.x) + 1, std::ceil(high.y) + 1};
  if (low.x == high.x)
    return low.x == cell.min.x ? Box2{{low.x - 1, min.y}, {low.x, max.y}} : Box2{{low.x, min.y}, {low.x + 1, max.y}};
  return low.y == cell.min.y ? Box2{{min.x, low.y - 1}, {max.x, low.y}} : Box2{{min.x, low.y}, {max.x, low.y + 1}};
}

// What the face has that has an edge of the partition's rim.
std::optional<std::uint32_t> surface_on_rim(const Partition& partition, GridPoint a, GridPoint b) {
  const auto& vertices = partition.triangulation.vertices();
  const auto& faces = partition.triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const GridPoint from = vertices[faces[f].vertices[(i + 1) % 3]], to = vertices[faces[f].vertices[(i + 2) % 3]];
      if (faces[f].neighbours[i] == kNoFace && std::minmax(from, to) == std::minmax(a, b))
        return partition.face_cover[f];
    }
  return std::nullopt;
}

// Pieces of the cell's border as one wherever nothing stays between them.
template <typename Stays>
std::vector<Border> joined_rim(std::vector<Border> rim, Stays stays) {
  const auto line = [](const Border& b) { return b.a.x == b.b.x ? std::pair(0, b.a.x) : std::pair(1, b.a.y); };
  std::ranges::sort(rim, {}, [&](const Border& b) { return std::pair(line(b), b.a); });
  std::vector<Border> joined;
  for (const Border& piece : rim) {
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
  // what ends a grid step outside may still round onto the border
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
  // lines have an owner of their own, under all others, so that none of them is lost
  const auto line_owner = static_cast<std::uint32_t>(layers.order.size());
  for (const auto& [a, b] : lines) segments.push_back({a, b, line_owner, 1});
  Arrangement arrangement = arrange(segments, points, cell);
  Delaunay triangulation = triangulated(arrangement);
  const LabelledFace known = known_face(triangulation, layers);
  std::vector<std::uint32_t> top = label_faces(triangulation, arrangement, known, ranks_of(line_owner + 1));
  for (std::uint32_t& owner : top) owner = owner >= line_owner ? kNoLandCover : layers.order[owner];
  return {std::move(arrangement), std::move(triangulation), std::move(top)};
}

std::vector<GridPoint> ring_joints(const NearbyCover& layers, const Arrangement& all, const Box2& cell) {
  std::vector<OwnedSegment> segments = segments_of(layers);
  std::erase_if(segments, [&](const OwnedSegment& s) { return !comes_near_border(s.a, s.b, cell); });
  std::vector<GridPoint> joints = arrange(segments, {}, cell).vertices;
  const auto is_passed = [&](GridPoint p) {
    return std::ranges::any_of(segments, [&](const OwnedSegment& s) { return passes(s, p); });
  };
  for (const GridPoint p : all.vertices)
    if (is_on_border(p, cell) && is_passed(p)) joints.push_back(p);
  std::erase_if(joints, [&](GridPoint p) { return !is_on_border(p, cell); });
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

std::vector<CellBorderPiece> cell_border_pieces(const NearbyCover& layers,
                                                std::span<const std::pair<GridPoint, GridPoint>> lines,
                                                std::span<const GridPoint> points, const Arrangement& all,
                                                const Box2& cell) {
  std::vector<CellBorderPiece> pieces;
  for (const ArrangedEdge& edge : all.edges) {
    const GridPoint a = all.vertices[edge.a], b = all.vertices[edge.b];
    const auto steps = std::span(all.steps).subspan(edge.first, edge.count);
    // lines have the last owner
    const auto is_of_ring = [&](const WindingStep& step) { return step.owner < layers.order.size(); };
    if (!is_on_rim(a, b, cell) || std::ranges::none_of(steps, is_of_ring)) continue;
    if (const auto there = surface_on_rim(partition_all_rings(layers, lines, points, beyond(a, b, cell)), a, b))
      pieces.push_back({a, b, *there});
  }
  return pieces;
}

std::vector<Border> empty_cell_borders(const Box2& cell) {
  const GridPoint sw = grid_point(cell.min), ne = grid_point(cell.max), se{ne.x, sw.y}, nw{sw.x, ne.y};
  const auto side = [](GridPoint a, GridPoint b) { return Border{a, b, kNoLandCover, kNoLandCover, true}; };
  return {side(sw, se), side(sw, nw), side(se, ne), side(nw, ne)};
}

std::vector<Border> visible_borders(const Partition& all, std::span<const GridPoint> joints) {
  std::vector<Border> borders, rim;
  const auto& faces = all.triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = faces[f].neighbours[i];
      if (!faces[f].is_constrained[i]) continue;
      const GridPoint a = all.triangulation.vertices()[faces[f].vertices[(i + 1) % 3]],
                      b = all.triangulation.vertices()[faces[f].vertices[(i + 2) % 3]];
      const std::uint32_t left = all.face_cover[f];
      if (beyond == kNoFace) rim.push_back({std::min(a, b), std::max(a, b), left, left, true});
      // an inner edge is met from both sides; the one that sees it from its lower end counts
      else if (a < b && left != all.face_cover[beyond])
        borders.push_back({a, b, left, all.face_cover[beyond], false});
    }
  const std::vector<GridPoint> kept = ends_of(borders);
  const auto stays = [&](GridPoint p) { return std::ranges::binary_search(kept, p) || is_near(joints, p); };
  const std::vector<Border> joined = joined_rim(std::move(rim), stays);
  borders.insert(borders.end(), joined.begin(), joined.end());
  return borders;
}

Partition partition_of_borders(std::span<const Border> borders, std::span<const GridPoint> points, const Box2& cell) {
  const std::vector<std::uint32_t> surfaces = surfaces_beside(borders);
  std::vector<OwnedSegment> segments;
  for (const Border& border : borders) {
    if (border.is_cell_border) continue;
    segments.push_back({border.a, border.b, place_in(surfaces, border.left), 1});
    segments.push_back({border.a, border.b, place_in(surfaces, border.right), -1});
  }
  Arrangement arrangement = arrange(segments, points, cell);
  Delaunay triangulation = triangulated(arrangement);
  const GridPoint corner = grid_point(cell.min);
  const LabelledFace known{corner_face(triangulation, corner),
                           {{place_in(surfaces, corner_surface(borders, corner)), 1}}};
  std::vector<std::uint32_t> top = label_faces(triangulation, arrangement, known, ranks_of(surfaces.size()));
  for (std::uint32_t& owner : top) owner = owner == kNoOwner ? kNoLandCover : surfaces[owner];
  return {std::move(arrangement), std::move(triangulation), std::move(top)};
}

}  // namespace citykiln::ground
