#include "compiler/geometry/triangles/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangles/constrain_edge.h"

namespace citykiln {
namespace {

constexpr std::uint32_t kNoPoint = 0xffffffffu;

// The index of a vertex's point; crossings that CGAL inserts have none at first.
struct PointIndex {
  std::uint32_t value = kNoPoint;
};

struct FaceState {
  bool is_seen = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PolygonVertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointIndex, Kernel>;
using PolygonFaceInfo = CGAL::Triangulation_face_base_with_info_2<FaceState, Kernel>;
using PolygonFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, PolygonFaceInfo>;
using PolygonCdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<PolygonVertexBase, PolygonFaceBase>, CGAL::Exact_predicates_tag>;

double triangle_area_m2(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a) / 2; }
Vec2 place_of(PolygonCdt::Vertex_handle v) { return {v->point().x(), v->point().y()}; }
Vec2 corner(PolygonCdt::Face_handle face, int i) { return place_of(face->vertex(i)); }

void insert_ring(PolygonCdt& cdt, const Ring& ring, std::vector<Vec2>& points) {
  std::vector<PolygonCdt::Vertex_handle> handles;
  for (const Vec2 p : ring) {
    const auto hint = handles.empty() ? PolygonCdt::Face_handle() : handles.back()->face();
    handles.push_back(cdt.insert({p.x, p.y}, hint));
    if (handles.back()->info().value == kNoPoint)
      handles.back()->info().value = static_cast<std::uint32_t>(points.size());
    points.push_back(p);
  }
  for (std::size_t i = 0; i < handles.size(); ++i)
    if (const auto next = handles[(i + 1) % handles.size()]; next != handles[i]) constrain_edge(cdt, handles[i], next);
}

// All faces connected to `start` without crossing a constraint.
std::vector<PolygonCdt::Face_handle> component_of(const PolygonCdt& cdt, PolygonCdt::Face_handle start) {
  std::vector<PolygonCdt::Face_handle> component = {start};
  start->info().is_seen = true;
  for (std::size_t next = 0; next < component.size(); ++next)
    for (int i = 0; i < 3; ++i) {
      const PolygonCdt::Face_handle beyond = component[next]->neighbor(i);
      if (component[next]->is_constrained(i) || cdt.is_infinite(beyond) || beyond->info().is_seen) continue;
      beyond->info().is_seen = true;
      component.push_back(beyond);
    }
  return component;
}

bool is_inside(const Polygon& polygon, const std::vector<PolygonCdt::Face_handle>& component) {
  double largest_m2 = -1;
  Vec2 middle;
  for (const PolygonCdt::Face_handle face : component) {
    const Vec2 a = corner(face, 0), b = corner(face, 1), c = corner(face, 2);
    if (triangle_area_m2(a, b, c) <= largest_m2) continue;
    largest_m2 = triangle_area_m2(a, b, c);
    middle = (a + b + c) * (1 / 3.0);
  }
  return contains(polygon, middle);
}

void append(PlaneTriangles& product, PolygonCdt::Face_handle face) {
  Triangle triangle;
  for (int i = 0; i < 3; ++i) {
    std::uint32_t& index = face->vertex(i)->info().value;
    if (index == kNoPoint) {
      index = static_cast<std::uint32_t>(product.points.size());
      product.points.push_back(snapped(corner(face, i)));
    }
    triangle[i] = index;
  }
  // snapping a crossing can give a triangle zero area
  const auto& p = product.points;
  if (triangle_area_m2(p[triangle[0]], p[triangle[1]], p[triangle[2]]) > 0) product.triangles.push_back(triangle);
}

}  // namespace

PlaneTriangles triangulate(const Polygon& polygon) {
  PlaneTriangles product;
  PolygonCdt cdt;
  insert_ring(cdt, polygon.outer, product.points);
  for (const Ring& hole : polygon.holes) insert_ring(cdt, hole, product.points);
  if (cdt.dimension() < 2) return product;
  for (const PolygonCdt::Face_handle face : cdt.finite_face_handles()) {
    if (face->info().is_seen) continue;
    const auto component = component_of(cdt, face);
    if (!is_inside(polygon, component)) continue;
    for (const PolygonCdt::Face_handle inside : component) append(product, inside);
  }
  return product;
}

}  // namespace citykiln
