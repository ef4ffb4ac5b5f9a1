#include "compiler/parcels/faces.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/triangles/delaunay.h"
#include "compiler/parcels/edge_owners.h"

namespace citykiln::parcels {
namespace {

// Triangles smaller than this have the label of their face.
constexpr double kLeastTriangle_m2 = 0.05;
// A face is divided if its part with other labels is at least this large.
constexpr double kLeastOther_m2 = 0.5;
constexpr double kLeastOtherShare = 0.01;

// Indexes of all that faces_of() looks up by place.
struct Indexes {
  BoxGrid ways, taken, footprints, borders;
};

template <typename Things, typename BoxOf>
BoxGrid index_of(const Things& things, BoxOf box_of_thing) {
  std::vector<Box2> boxes;
  for (const auto& thing : things) boxes.push_back(box_of_thing(thing));
  return grid_of(boxes, 64);
}

Indexes indexes_of(const Layout& layout) {
  return {index_of(layout.ways, [](const RightOfWayPiece& s) { return box_of(s.ring); }),
          index_of(layout.taken, [](const Polygon& p) { return box_of(p.outer); }),
          index_of(layout.footprints, [](const Footprint& f) { return box_of(f.ring); }),
          index_of(layout.borders, [](const auto& b) { return box_of_segment(b.first, b.second); })};
}

// The parts of a layout in or near one cell.
struct CellParts {
  Box2 cell;
  std::vector<std::uint32_t> ways, footprints;
  std::vector<std::vector<Ring>> taken;  // the rings of each polygon near the cell
  std::vector<OwnedSegment> segments;
  std::vector<Border> owners;
};

void add_segment(CellParts& parts, Vec2 a, Vec2 b, Border border) {
  const GridPoint p = grid_point(a), q = grid_point(b);
  if (p == q) return;
  // equal owners would cancel each other
  parts.segments.push_back({p, q, static_cast<std::uint32_t>(parts.owners.size()), 1});
  parts.owners.push_back(border);
}

void add_border_ring(CellParts& parts, const Ring& ring, Border border) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) add_segment(parts, ring[j], ring[i], border);
}

std::vector<Ring> trimmed_rings(const Polygon& polygon, const Box2& box) {
  std::vector<Ring> rings;
  for (const Ring* ring : rings_of(polygon))
    if (Ring trimmed = trimmed_to(*ring, box); trimmed.size() > 2) rings.push_back(std::move(trimmed));
  return rings;
}

CellParts parts_of(const Layout& layout, const Indexes& indexes, const Box2& cell) {
  CellParts parts{cell, {}, {}, {}, {}, {}};
  const Box2 near = cell.widened(1);
  parts.ways = boxes_about(indexes.ways, near);
  for (const std::uint32_t i : parts.ways)
    for (std::size_t k = 0, n = layout.ways[i].ring.size(); k < n; ++k)
      add_segment(parts, layout.ways[i].ring[k], layout.ways[i].ring[(k + 1) % n], layout.ways[i].borders[k]);
  for (const std::uint32_t i : boxes_about(indexes.taken, near))
    parts.taken.push_back(trimmed_rings(layout.taken[i], near));
  for (const std::vector<Ring>& rings : parts.taken)
    for (const Ring& ring : rings) add_border_ring(parts, ring, {.kind = BorderKind::kTaken});
  parts.footprints = boxes_about(indexes.footprints, near);
  for (const std::uint32_t i : parts.footprints) add_border_ring(parts, layout.footprints[i].ring, {});
  for (const std::uint32_t i : boxes_about(indexes.borders, near))
    add_segment(parts, layout.borders[i].first, layout.borders[i].second, {});
  const Vec2 low = layout.extent.min, high = layout.extent.max;
  add_border_ring(parts, {low, {high.x, low.y}, high, {low.x, high.y}}, {.kind = BorderKind::kExtent});
  return parts;
}

std::uint32_t label_at_place(const Layout& layout, Vec2 p) {
  const std::uint32_t piece = nearest_piece(*layout.field, p);
  const std::uint32_t label = piece == kNoIndex ? kRest : layout.field->pieces[piece].label;
  return layout.splits ? split_label(*layout.splits, label, p) : label;
}

Face face_at(const Layout& layout, const CellParts& parts, Vec2 p) {
  Face face;
  const auto is_right_of_way = [&](std::uint32_t i) { return is_in_convex(layout.ways[i].ring, p); };
  const auto is_around = [&](const Ring& ring) { return winding_number(ring, p) != 0; };
  const auto is_taken = [&](const std::vector<Ring>& rings) {
    int winding = 0;
    for (const Ring& ring : rings) winding += winding_number(ring, p);
    return winding != 0;
  };
  for (const std::uint32_t i : parts.footprints)
    if (face.footprint == kNoIndex && is_around(layout.footprints[i].ring)) face.footprint = i;
  if (!layout.extent.contains(p))
    face.kind = FaceKind::kOutside;
  else if (std::ranges::any_of(parts.ways, is_right_of_way))
    face.kind = FaceKind::kLine;
  else if (std::ranges::any_of(parts.taken, is_taken))
    face.kind = FaceKind::kTaken;
  if (face.kind == FaceKind::kLand) face.label = label_at_place(layout, p);
  return face;
}

// The border of the lowest kind, then of the first line, among the owners of an edge.
Border border_of(const Arrangement& arrangement, const std::vector<Border>& owners, std::uint32_t a, std::uint32_t b) {
  const auto key = [](const ArrangedEdge& e) { return std::pair(e.a, e.b); };
  const auto edge = std::ranges::lower_bound(arrangement.edges, std::pair(std::min(a, b), std::max(a, b)), {}, key);
  Border best;
  const auto rank = [](const Border& x) { return std::tuple(x.kind, x.line, x.segment, x.side); };
  if (edge != arrangement.edges.end() && edge->a == std::min(a, b) && edge->b == std::max(a, b))
    for (std::uint32_t i = edge->first; i < edge->first + edge->count; ++i)
      if (const Border& other = owners[arrangement.steps[i].owner]; rank(other) < rank(best)) best = other;
  return best;
}

// A cell's arrangement and its triangles.
struct CellMesh {
  Arrangement arrangement;
  std::vector<DelaunayFace> triangles;

  double area_m2(std::uint32_t i) const {
    const auto& [a, b, c] = triangles[i].vertices;
    const auto& v = arrangement.vertices;
    return static_cast<double>(turn(v[a], v[b], v[c])) * (kQuantum_m * kQuantum_m / 2);
  }
  Vec2 centre(std::uint32_t i) const {
    Vec2 sum;
    for (const std::uint32_t v : triangles[i].vertices) sum = sum + plane_point(arrangement.vertices[v]);
    return sum * (1.0 / 3);
  }
};

CellMesh mesh_of(const CellParts& parts) {
  CellMesh mesh{arrange(parts.segments, {}, parts.cell), {}};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : mesh.arrangement.edges) edges.emplace_back(e.a, e.b);
  mesh.triangles = Delaunay(mesh.arrangement.vertices, edges).faces();
  return mesh;
}

// The lowest triangle of each set of triangles, joined over edges that are not constrained if is_same(i, j).
template <typename IsSame>
std::vector<std::uint32_t> joined_triangles(const std::vector<DelaunayFace>& triangles, IsSame is_same) {
  DisjointSets sets(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (const std::uint32_t j = triangles[i].neighbours[k]; !triangles[i].is_constrained[k] && j != kNoFace)
        if (is_same(i, j)) sets.join(i, j);
  return sets.lowest();
}

// The kind of each set of triangles, at its lowest one, by the centre of its largest one.
std::vector<Face> faces_at(const Layout& layout, const CellParts& parts, const CellMesh& mesh,
                           const std::vector<std::uint32_t>& roots) {
  std::vector<std::uint32_t> largest(roots.size(), kNoIndex);
  for (std::uint32_t i = 0; i < roots.size(); ++i)
    if (largest[roots[i]] == kNoIndex || mesh.area_m2(i) > mesh.area_m2(largest[roots[i]])) largest[roots[i]] = i;
  std::vector<Face> faces(roots.size());
  for (std::uint32_t i = 0; i < roots.size(); ++i)
    if (roots[i] == i) faces[i] = face_at(layout, parts, mesh.centre(largest[i]));
  return faces;
}

// The label of each triangle: that of its face, except in faces of which a part that matters has other labels, since a
// border is missing there. These are divided along edges of triangles.
std::vector<std::uint32_t> triangle_labels(const Layout& layout, const CellMesh& mesh,
                                           const std::vector<std::uint32_t>& roots, const std::vector<Face>& faces) {
  std::vector<std::uint32_t> labels(roots.size());
  std::vector<double> area(roots.size(), 0), other(roots.size(), 0);
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    const Face& face = faces[roots[i]];
    labels[i] = face.label;
    if (face.kind != FaceKind::kLand) continue;
    area[roots[i]] += mesh.area_m2(i);
    if (mesh.area_m2(i) < kLeastTriangle_m2) continue;
    labels[i] = label_at_place(layout, mesh.centre(i));
    if (labels[i] != face.label) other[roots[i]] += mesh.area_m2(i);
  }
  for (std::uint32_t i = 0; i < roots.size(); ++i)
    if (other[roots[i]] < std::max(kLeastOther_m2, kLeastOtherShare * area[roots[i]]))
      labels[i] = faces[roots[i]].label;
  return labels;
}

Faces faces_of_cell(const Layout& layout, const Indexes& indexes, const Box2& cell) {
  const CellParts parts = parts_of(layout, indexes, cell);
  const CellMesh mesh = mesh_of(parts);
  const auto whole = joined_triangles(mesh.triangles, [](auto, auto) { return true; });
  const std::vector<Face> kinds = faces_at(layout, parts, mesh, whole);
  const std::vector<std::uint32_t> labels = triangle_labels(layout, mesh, whole, kinds);
  const auto roots = joined_triangles(mesh.triangles, [&](auto i, auto j) { return labels[i] == labels[j]; });
  Faces faces;
  std::vector<std::uint32_t> number(roots.size());
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    if (roots[i] == i) {
      number[i] = static_cast<std::uint32_t>(faces.faces.size());
      faces.faces.push_back(kinds[whole[i]]);
      faces.faces.back().label = labels[i];
    }
    number[i] = number[roots[i]];
    faces.faces[number[i]].area_m2 += mesh.area_m2(i);
  }
  for (std::uint32_t i = 0; i < roots.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const DelaunayFace& t = mesh.triangles[i];
      if (!t.is_constrained[k] && t.neighbours[k] != kNoFace && number[t.neighbours[k]] == number[i]) continue;
      const std::uint32_t a = t.vertices[(k + 1) % 3], b = t.vertices[(k + 2) % 3];
      faces.edges.push_back({mesh.arrangement.vertices[a], mesh.arrangement.vertices[b], number[i], kNoIndex,
                             border_of(mesh.arrangement, parts.owners, a, b)});
    }
  return faces;
}

std::vector<Box2> cells_of(const Box2& extent) {
  std::vector<Box2> cells;
  const auto low = [](double v) { return std::floor(v / kFaceCell_m) * kFaceCell_m; };
  for (double y = low(extent.min.y); y < extent.max.y; y += kFaceCell_m)
    for (double x = low(extent.min.x); x < extent.max.x; x += kFaceCell_m)
      cells.push_back({{x, y}, {x + kFaceCell_m, y + kFaceCell_m}});
  return cells;
}

void find_beyond(std::vector<FaceEdge>& edges) {
  const auto key = [](const FaceEdge& e) { return std::tie(e.from, e.to); };
  std::ranges::sort(edges, {}, key);
  for (FaceEdge& edge : edges) {
    const auto twin = std::ranges::lower_bound(edges, std::tie(edge.to, edge.from), {}, key);
    if (twin != edges.end() && twin->from == edge.to && twin->to == edge.from) edge.beyond = twin->face;
  }
}

}  // namespace

Faces faces_of(const Layout& layout, int threads) {
  const Indexes indexes = indexes_of(layout);
  const std::vector<Box2> cells = cells_of(layout.extent);
  const auto parts = for_each_slot<Faces>(cells.size(), threads,
                                          [&](std::size_t i) { return faces_of_cell(layout, indexes, cells[i]); });
  Faces all;
  for (const Faces& cell : parts) {
    const auto offset = static_cast<std::uint32_t>(all.faces.size());
    all.faces.insert(all.faces.end(), cell.faces.begin(), cell.faces.end());
    for (FaceEdge edge : cell.edges) {
      edge.face += offset;
      all.edges.push_back(edge);
    }
  }
  find_beyond(all.edges);
  return all;
}

}  // namespace citykiln::parcels
