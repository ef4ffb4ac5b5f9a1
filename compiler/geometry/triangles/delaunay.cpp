#include "compiler/geometry/triangles/delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cassert>

#include "compiler/geometry/grid_point_set.h"
#include "compiler/geometry/triangles/constrain_edge.h"

namespace citykiln {
namespace {

struct FaceNumber {
  std::uint32_t value = kNoFace;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using GridVertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using GridFaceInfo = CGAL::Triangulation_face_base_with_info_2<FaceNumber, Kernel>;
using GridFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, GridFaceInfo>;
using GridCdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<GridVertexBase, GridFaceBase>, CGAL::No_constraint_intersection_tag>;

// Integers below 2^29 are exact in doubles, and CGAL's predicates are exact. The coordinates are turned left by a right
// angle, because of four cocircular points CGAL cuts off the last by (x, y): for a rectangle that is now the
// south-eastern corner.
GridCdt::Point cgal_point(GridPoint p) { return {static_cast<double>(-p.y), static_cast<double>(p.x)}; }

}  // namespace

struct Delaunay::Triangulation {
  explicit Triangulation(std::span<const GridPoint> points) : vertices(points.begin(), points.end()), places(points) {}

  GridCdt cdt;
  std::vector<GridPoint> vertices;
  GridPointSet places;  // the vertices again
  std::vector<DelaunayFace> faces;
  std::vector<GridCdt::Face_handle> handles;
  std::vector<std::uint32_t> changed;

  void number(GridCdt::Face_handle face) {
    face->info().value = static_cast<std::uint32_t>(faces.size());
    faces.emplace_back();
    handles.push_back(face);
  }

  // Copies CGAL's face into ours. All finite neighbours must have numbers already.
  void refresh(GridCdt::Face_handle face) {
    DelaunayFace& ours = faces[face->info().value];
    for (int i = 0; i < 3; ++i) {
      ours.vertices[i] = face->vertex(i)->info();
      ours.is_constrained[i] = face->is_constrained(i);
      ours.neighbours[i] = face->neighbor(i)->info().value;
    }
  }

  void refresh_about(GridCdt::Vertex_handle vertex) {
    changed.clear();
    GridCdt::Face_circulator around = cdt.incident_faces(vertex), begin = around;
    do {
      if (cdt.is_infinite(around)) continue;
      if (around->info().value == kNoFace) number(around);
      changed.push_back(around->info().value);
    } while (++around != begin);
    for (const std::uint32_t face : changed) refresh(handles[face]);
    // faces outside the changed ones get the new neighbour numbers
    for (const std::uint32_t face : changed) refresh_beyond(face, vertex);
  }

  void refresh_neighbours(GridCdt::Face_handle face) {
    for (int i = 0; i < 3; ++i)
      if (const GridCdt::Face_handle beyond = face->neighbor(i); !cdt.is_infinite(beyond)) refresh(beyond);
  }

  void refresh_beyond(std::uint32_t face, GridCdt::Vertex_handle vertex) {
    const GridCdt::Face_handle handle = handles[face];
    const GridCdt::Face_handle beyond = handle->neighbor(handle->index(vertex));
    if (!cdt.is_infinite(beyond)) refresh(beyond);
  }
};

Delaunay::Delaunay(std::span<const GridPoint> vertices, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges)
    : triangulation_(std::make_unique<Triangulation>(vertices)) {
  assert(std::ranges::all_of(
      edges, [&](auto e) { return std::max(e.first, e.second) < vertices.size() && e.first != e.second; }));
  Triangulation& t = *triangulation_;
  std::vector<std::pair<GridCdt::Point, std::uint32_t>> points;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) points.emplace_back(cgal_point(vertices[i]), i);
  t.cdt.insert(points.begin(), points.end());
  std::vector<GridCdt::Vertex_handle> handles(vertices.size());
  for (const GridCdt::Vertex_handle v : t.cdt.finite_vertex_handles()) handles[v->info()] = v;
  for (const auto& [a, b] : edges) constrain_edge(t.cdt, handles[a], handles[b]);
  for (const GridCdt::Face_handle face : t.cdt.finite_face_handles()) t.number(face);
  for (const GridCdt::Face_handle face : t.handles) t.refresh(face);
}

Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

const std::vector<GridPoint>& Delaunay::vertices() const { return triangulation_->vertices; }
const std::vector<DelaunayFace>& Delaunay::faces() const { return triangulation_->faces; }

std::uint32_t Delaunay::face_to_split(GridPoint p, std::uint32_t near) const {
  assert(near < triangulation_->handles.size());
  const Triangulation& t = *triangulation_;
  // refining asks for many vertices that the mesh has already, far from the face
  if (t.places.contains(p)) return kNoFace;
  GridCdt::Locate_type where;
  int corner = 0;
  const GridCdt::Face_handle face = t.cdt.locate(cgal_point(p), where, corner, t.handles[near]);
  const bool on_constraint = where == GridCdt::EDGE && face->is_constrained(corner);
  if (on_constraint || (where != GridCdt::FACE && where != GridCdt::EDGE)) return kNoFace;
  return t.cdt.is_infinite(face) ? kNoFace : face->info().value;
}

std::span<const std::uint32_t> Delaunay::insert(GridPoint p, std::uint32_t face) {
  assert(face < triangulation_->handles.size());
  Triangulation& t = *triangulation_;
  const GridCdt::Vertex_handle vertex = t.cdt.insert(cgal_point(p), t.handles[face]);
  vertex->info() = static_cast<std::uint32_t>(t.vertices.size());
  t.vertices.push_back(p);
  t.places.insert(p);
  t.refresh_about(vertex);
  return t.changed;
}

std::span<const std::uint32_t> Delaunay::flip(std::uint32_t face, int i) {
  assert(face < faces().size() && i >= 0 && i < 3);
  assert(!faces()[face].is_constrained[i] && faces()[face].neighbours[i] != kNoFace);
  Triangulation& t = *triangulation_;
  const GridCdt::Face_handle one = t.handles[face], other = one->neighbor(i);
  t.cdt.flip(t.handles[face], i);
  t.changed = {one->info().value, other->info().value};
  for (const GridCdt::Face_handle handle : {one, other}) {
    t.refresh(handle);
    t.refresh_neighbours(handle);
  }
  return t.changed;
}

}  // namespace citykiln
