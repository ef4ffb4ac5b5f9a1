// val3dity's rules for solids, implemented a second time: codes 1xx (rings), 2xx (faces) and 3xx (shells) of val3dity
// 2, by GEOS and CGAL, so that the checks do not depend on citykiln's own geometry.
//
// Ledoux 2013, "On the validation of solids represented with the international standards for geographic information".
// Tolerances are val3dity's own: 1 cm and 20 degrees for planes. Two checks are stricter here. Points are merged only
// if they are equal (its default merges points within 1 mm, which is our grid's step), and every code is looked for (it
// stops at the first level that fails). One is milder: the normal of triangles thinner than 2 cm, the thickness that a
// face may have about its plane, is not checked (204).
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <geos_c.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::val3dity {

using grammars::Face;
using Codes = std::set<int>;
using Ring = std::vector<Vec3>;
using PlaneRing = std::vector<Vec2>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kToPlane_m = 0.01, kBetweenNormals_deg = 20;

// ---- rings: 1xx

inline Ring ring_of(std::span<const Vec3> points) { return {points.begin(), points.end()}; }

inline Vec3 newell(const Ring& ring) {
  Vec3 sum;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum = sum + cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

/// Projects a point into a plane and keeps the orientation. Faces that are not vertical are seen from above, which is
/// exact, while a rotation would round. Vertical faces are projected along the horizontal part of the normal.
inline Vec2 flattened(Vec3 p, Vec3 normal) {
  if (std::abs(normal.z) > 1e-3) return normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x};
  return {p.y * normal.x - p.x * normal.y, p.z};
}

inline PlaneRing projected(const Ring& ring, Vec3 normal) {
  PlaneRing flat;
  for (const Vec3 p : ring) flat.push_back(flattened(p, normal));
  return flat;
}

inline double signed_area_m2(const PlaneRing& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return twice / 2;
}

inline void keep_silent(const char*, ...) {}
struct Geos {
  Geos() { initGEOS(keep_silent, keep_silent); }
  ~Geos() { finishGEOS(); }
};
using Geometry = std::unique_ptr<GEOSGeometry, decltype([](GEOSGeometry* g) { GEOSGeom_destroy(g); })>;

inline GEOSGeometry* linear_ring(const PlaneRing& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create(size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) GEOSCoordSeq_setXY(points, i, ring[i % size].x, ring[i % size].y);
  return GEOSGeom_createLinearRing(points);
}

inline void check_ring(const Ring& ring, Vec3 normal, Codes& codes) {
  if (std::set<Vec3>(ring.begin(), ring.end()).size() < 3) {
    codes.insert(101);
    return;
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ring[(i + 1) % ring.size()]) codes.insert(102);
  if (length(normal) == 0 || GEOSisSimple(Geometry(linear_ring(projected(ring, normal))).get()) != 1) codes.insert(104);
}

// ---- faces: 2xx

/// Returns the code for a reason as GEOS names it.
inline int code_named(std::string_view reason) {
  constexpr std::pair<std::string_view, int> kReasons[] = {
      {"Hole lies outside shell", 206}, {"Holes are nested", 207},  {"Interior is disconnected", 205},
      {"Duplicate Rings", 202},         {"Self-intersection", 201}, {"Ring Self-intersection", 104}};
  for (const auto& [name, code] : kReasons)
    if (reason.starts_with(name)) return code;
  return 200;
}

inline std::set<Vec3> places_of(std::span<const Vec3> ring) { return {ring.begin(), ring.end()}; }

// Adds 202 for equal rings, which GEOS no longer reports.
inline void check_twice(const Face& face, Codes& codes) {
  std::set<std::set<Vec3>> rings = {places_of(face.outer)};
  for (const auto& hole : face.holes)
    if (!rings.insert(places_of(hole)).second) codes.insert(202);
}

inline void check_rings_together(const Face& face, Vec3 normal, Codes& codes) {
  std::vector<GEOSGeometry*> holes;
  for (const auto& hole : face.holes) {
    const PlaneRing flat = projected(ring_of(hole), normal);
    if (signed_area_m2(flat) >= 0) codes.insert(208);
    holes.push_back(linear_ring(flat));
  }
  const Geometry polygon(GEOSGeom_createPolygon(linear_ring(projected(ring_of(face.outer), normal)), holes.data(),
                                                static_cast<unsigned>(holes.size())));
  if (GEOSisValid(polygon.get()) == 1) return;
  char* reason = GEOSisValidReason(polygon.get());
  codes.insert(code_named(reason));
  GEOSFree(reason);
}

inline std::vector<Vec3> points_of(const Face& face) {
  std::vector<Vec3> points;
  each_vertex(face, [&](const Vec3& p) { points.push_back(p); });
  return points;
}

// The normal of the best plane is the axis of least variance.
inline void check_plane(const Face& face, Codes& codes) {
  const std::vector<Vec3> points = points_of(face);
  if (points.size() == 3) return;
  const Vec3 middle = std::accumulate(points.begin(), points.end(), Vec3{}) * (1 / static_cast<double>(points.size()));
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3 p : points) {
    const Eigen::Vector3d off(p.x - middle.x, p.y - middle.y, p.z - middle.z);
    spread += off * off.transpose();
  }
  const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  for (const Vec3 p : points)
    if (std::abs(dot(p - middle, {normal[0], normal[1], normal[2]})) > kToPlane_m) codes.insert(203);
}

/// @return whether the face may be triangulated.
inline bool check_face(const Face& face, Codes& codes) {
  Codes of_rings;
  const Vec3 normal = unit(newell(ring_of(face.outer)));
  check_ring(ring_of(face.outer), normal, of_rings);
  for (const auto& hole : face.holes) check_ring(ring_of(hole), normal, of_rings);
  if (of_rings.empty()) check_rings_together(face, normal, of_rings);
  check_twice(face, of_rings);
  check_plane(face, codes);
  codes.insert(of_rings.begin(), of_rings.end());
  return of_rings.empty();
}

// ---- shells: 3xx

using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Insides =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Insides>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using LandCoverPolygon = CGAL::Surface_mesh<Kernel::Point_3>;

struct Shell {
  std::vector<Vec3> positions;
  std::map<Vec3, std::uint32_t> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline std::uint32_t vertex_at(Shell& shell, Vec3 p) {
  const auto [at, is_new] = shell.places.try_emplace(p, static_cast<std::uint32_t>(shell.positions.size()));
  if (is_new) shell.positions.push_back(p);
  return at->second;
}

inline void constrain(Triangulation& plane, const Ring& ring, Vec3 normal, Shell& shell) {
  std::vector<Triangulation::Vertex_handle> handles;
  for (const Vec3 p : ring) {
    const Vec2 flat = flattened(p, normal);
    handles.push_back(plane.insert({flat.x, flat.y}));
    handles.back()->info() = vertex_at(shell, p);
  }
  for (std::size_t i = 0; i < handles.size(); ++i)
    plane.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
}

/// Counts the rings around each triangle, modulo 2: triangles with 1 are the face.
inline void count_rings_around(Triangulation& plane) {
  for (auto face = plane.all_faces_begin(); face != plane.all_faces_end(); ++face) face->info() = -1;
  std::vector<Triangulation::Face_handle> front = {plane.infinite_face()};
  front[0]->info() = 0;
  // a triangle behind a constraint is one ring deeper, on any path
  for (std::size_t at = 0; at < front.size(); ++at)
    for (int i = 0; i < 3; ++i) {
      const auto next = front[at]->neighbor(i);
      if (next->info() >= 0) continue;
      next->info() = front[at]->info() ^ (plane.is_constrained({front[at], i}) ? 1 : 0);
      front.push_back(next);
    }
}

inline Vec3 normal_of(const Shell& shell, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = shell.positions[t[0]];
  return unit(cross(shell.positions[t[1]] - a, shell.positions[t[2]] - a));
}

/// The height of a triangle over its longest side.
inline double least_height_m(const Shell& shell, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = shell.positions[t[0]], b = shell.positions[t[1]], c = shell.positions[t[2]];
  return length(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)});
}

inline void add_face(const Face& face, Shell& shell, Codes& codes) {
  const Vec3 normal = unit(newell(ring_of(face.outer)));
  Triangulation plane;
  constrain(plane, ring_of(face.outer), normal, shell);
  for (const auto& hole : face.holes) constrain(plane, ring_of(hole), normal, shell);
  count_rings_around(plane);
  const std::size_t first = shell.triangles.size();
  for (auto t = plane.finite_faces_begin(); t != plane.finite_faces_end(); ++t)
    if (t->info() == 1) shell.triangles.push_back({t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()});
  const double least = std::cos(kBetweenNormals_deg * 3.14159265358979 / 180);
  for (std::size_t i = first; i < shell.triangles.size(); ++i)
    if (least_height_m(shell, shell.triangles[i]) > 2 * kToPlane_m &&
        dot(normal_of(shell, shell.triangles[i]), normal) < least)
      codes.insert(204);
}

inline void check_edges(const Shell& shell, Codes& codes) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> along;
  for (const auto& t : shell.triangles)
    for (int i = 0; i < 3; ++i) ++along[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : along) {
    const auto back = along.find({edge.second, edge.first});
    const int backward = back == along.end() ? 0 : back->second;
    if (count + backward > 2) codes.insert(303);
    if (count + backward == 1) codes.insert(302);
    if (count == 2 && backward == 0) codes.insert(307);
  }
}

/// Adds 303 if the triangles around a vertex are not one fan.
inline void check_fans(const Shell& shell, Codes& codes) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> around(shell.positions.size());
  for (const auto& t : shell.triangles)
    for (int i = 0; i < 3; ++i) around[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  for (const auto& fan : around) {
    if (fan.empty()) continue;
    std::size_t steps = 0;
    auto at = fan.begin();
    do {
      at = fan.find(at->second);
      ++steps;
    } while (at != fan.end() && at != fan.begin() && steps <= fan.size());
    if (at != fan.end() && steps != fan.size()) codes.insert(303);
  }
}

inline std::size_t pieces_of(const Shell& shell) {
  std::vector<std::uint32_t> root(shell.positions.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : shell.triangles) root[find(t[0])] = find(t[1]), root[find(t[1])] = find(t[2]);
  std::set<std::uint32_t> roots;
  for (const auto& t : shell.triangles) roots.insert(find(t[0]));
  return roots.size();
}

/// Adds 306 and 307 by CGAL, which needs a manifold.
inline void check_surface(const Shell& shell, Codes& codes) {
  LandCoverPolygon surface;
  for (const Vec3 p : shell.positions) surface.add_vertex({p.x, p.y, p.z});
  for (const auto& [a, b, c] : shell.triangles)
    if (surface.add_face(LandCoverPolygon::Vertex_index(a), LandCoverPolygon::Vertex_index(b),
                         LandCoverPolygon::Vertex_index(c)) == LandCoverPolygon::null_face()) {
      codes.insert(303);
      return;
    }
  if (CGAL::Polygon_mesh_processing::does_self_intersect(surface)) codes.insert(306);
  if (CGAL::is_closed(surface) && !CGAL::Polygon_mesh_processing::is_outward_oriented(surface)) codes.insert(307);
}

/// Returns the codes of all faults of a solid bounded by one shell.
inline Codes codes_of(std::span<const Face> faces) {
  const Geos geos;
  Codes codes;
  Shell shell;
  if (faces.size() < 4) codes.insert(301);
  bool is_whole = true;
  for (const Face& face : faces) {
    if (check_face(face, codes))
      add_face(face, shell, codes);
    else
      is_whole = false;
  }
  if (!is_whole) return codes;
  check_edges(shell, codes);
  check_fans(shell, codes);
  if (pieces_of(shell) > 1) codes.insert(305);
  if (!codes.contains(302) && !codes.contains(303)) check_surface(shell, codes);
  return codes;
}

}  // namespace citykiln::val3dity
