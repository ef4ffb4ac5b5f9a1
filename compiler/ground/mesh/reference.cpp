#include "compiler/ground/mesh/reference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "compiler/geometry/triangles/straight_walk.h"

namespace citykiln::ground {
namespace {

TriangulationView walk_ground(const Reference& reference) {
  return {reference.triangulation.vertices(), reference.triangulation.faces(), reference.first_faces};
}

double height_of(const Reference& reference, std::uint32_t vertex, HeightLayer layer) {
  return reference.heights[vertex][static_cast<std::size_t>(layer)];
}

// Returns the centre of a bucket, moved into the cell.
FinePoint centre_of(const Reference& reference, std::int64_t column, std::int64_t row) {
  const GridPoint min = reference.buckets.min, max = grid_point(reference.cell.max);
  const std::int64_t side = reference.buckets.side;
  return fine_point(
      GridPoint{std::min(min.x + column * side + side / 2, max.x), std::min(min.y + row * side + side / 2, max.y)});
}

std::uint32_t end_of(StraightWalk walk) {
  while (!next(walk).is_end()) {
  }
  return walk.face;
}

// Walks from centre to centre, row by row.
std::vector<std::uint32_t> faces_at_centres(const Reference& reference) {
  std::vector<std::uint32_t> faces;
  const PointBuckets& buckets = reference.buckets;
  std::uint32_t row_start = end_of(walk_from_vertex(walk_ground(reference), 0, centre_of(reference, 0, 0)));
  for (std::int64_t row = 0; row < buckets.rows; ++row) {
    const FinePoint below = centre_of(reference, 0, std::max<std::int64_t>(row - 1, 0));
    row_start = end_of(walk_from_face(walk_ground(reference), row_start, below, centre_of(reference, 0, row)));
    faces.push_back(row_start);
    for (std::int64_t column = 1; column < buckets.columns; ++column)
      faces.push_back(end_of(walk_from_face(walk_ground(reference), faces.back(), centre_of(reference, column - 1, row),
                                            centre_of(reference, column, row))));
  }
  return faces;
}

// Returns the face at p by walking straight from its bucket's centre. `near`: p on the grid.
std::uint32_t face_at(const Reference& reference, FinePoint p, GridPoint near) {
  const std::int64_t column = reference.buckets.column(near.x), row = reference.buckets.row(near.y);
  const std::uint32_t start =
      reference.centre_faces[static_cast<std::size_t>(row * reference.buckets.columns + column)];
  return end_of(walk_from_face(walk_ground(reference), start, centre_of(reference, column, row), p));
}

// Returns how far along from a to b a point between them is, 0 to 1; the differences are whole, hence exact.
double share_along(FinePoint a, FinePoint b, FinePoint p) {
  const bool by_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  return by_x ? static_cast<double>(p.x - a.x) / static_cast<double>(b.x - a.x)
              : static_cast<double>(p.y - a.y) / static_cast<double>(b.y - a.y);
}

double value_between(double from, double to, double share) { return from + (to - from) * share; }

double height_on_edge(const Reference& reference, std::uint32_t u, std::uint32_t v, FinePoint p, HeightLayer layer) {
  const auto& vertices = reference.triangulation.vertices();
  // from the lower end, so that both directions give the same bits
  if (vertices[v] < vertices[u]) std::swap(u, v);
  const double share = share_along(fine_point(vertices[u]), fine_point(vertices[v]), p);
  return value_between(height_of(reference, u, layer), height_of(reference, v, layer), share);
}

double height_inside(const Reference& reference, const DelaunayFace& face, FinePoint p, HeightLayer layer) {
  const auto& vertices = reference.triangulation.vertices();
  const auto offset = [&](FinePoint q) {
    const FinePoint origin = fine_point(vertices[face.vertices[0]]);
    return Vec2{static_cast<double>(q.x - origin.x), static_cast<double>(q.y - origin.y)};
  };
  const Vec2 u = offset(fine_point(vertices[face.vertices[1]])), v = offset(fine_point(vertices[face.vertices[2]]));
  const double area = cross(u, v), s = cross(offset(p), v) / area, t = cross(u, offset(p)) / area;
  const double z = height_of(reference, face.vertices[0], layer);
  return z + s * (height_of(reference, face.vertices[1], layer) - z) +
         t * (height_of(reference, face.vertices[2], layer) - z);
}

// An edge of a mesh with its ends on the grid.
struct MeshEdge {
  Vec3 a, b;
  GridPoint from, to;
};

void consider_vertex(WorstPoint& worst, const Reference& reference, const MeshEdge& edge, std::uint32_t v,
                     HeightLayer layer) {
  const GridPoint place = reference.triangulation.vertices()[v];
  const double share = share_along(fine_point(edge.from), fine_point(edge.to), fine_point(place));
  consider(worst, std::abs(value_between(edge.a.z, edge.b.z, share) - height_of(reference, v, layer)),
           plane_point(place));
}

void consider_crossing(WorstPoint& worst, const Reference& reference, const MeshEdge& edge, WalkStep met,
                       HeightLayer layer) {
  const GridPoint p = reference.triangulation.vertices()[met.p], q = reference.triangulation.vertices()[met.q];
  // whole numbers below 2^62: their difference is exact
  const std::int64_t from_a = turn(p, q, edge.from), from_b = turn(p, q, edge.to);
  const std::int64_t from_p = turn(edge.from, edge.to, p), from_q = turn(edge.from, edge.to, q);
  const double along_edge = static_cast<double>(from_a) / static_cast<double>(from_a - from_b);
  const double along_met = static_cast<double>(from_p) / static_cast<double>(from_p - from_q);
  const double z = value_between(height_of(reference, met.p, layer), height_of(reference, met.q, layer), along_met);
  consider(worst, std::abs(value_between(edge.a.z, edge.b.z, along_edge) - z),
           in_plan(edge.a + (edge.b - edge.a) * along_edge));
}

bool lies_along_border(const Box2& cell, Vec3 a, Vec3 b) {
  return (a.x == b.x && (a.x == cell.min.x || a.x == cell.max.x)) ||
         (a.y == b.y && (a.y == cell.min.y || a.y == cell.max.y));
}

// How a place lies in its face: on corner `first`, on the edge that starts there, or inside.
struct InFace {
  enum class Where { kCorner, kEdge, kInside } where;
  int first = 0;
};

InFace in_face(const Reference& reference, const DelaunayFace& face, FinePoint p) {
  const auto place = [&](int i) { return fine_point(reference.triangulation.vertices()[face.vertices[i % 3]]); };
  for (int i = 0; i < 3; ++i)
    if (place(i) == p) return {InFace::Where::kCorner, i};
  for (int i = 0; i < 3; ++i)
    if (side_of(place(i), place(i + 1), p) == 0) return {InFace::Where::kEdge, i};
  return {InFace::Where::kInside};
}

double height_in_face(const Reference& reference, const DelaunayFace& face, InFace in, FinePoint p, HeightLayer layer) {
  if (in.where == InFace::Where::kCorner) return height_of(reference, face.vertices[in.first], layer);
  if (in.where == InFace::Where::kEdge)
    return height_on_edge(reference, face.vertices[in.first], face.vertices[(in.first + 1) % 3], p, layer);
  return height_inside(reference, face, p, layer);
}

// Doubled areas opposite to each corner: barycentric coordinates before division.
using Areas = std::array<std::int64_t, 3>;

// A triangle in plan with the plane through its corners.
struct TrianglePlane {
  std::array<GridPoint, 3> corners;
  std::array<Vec3, 3> heights;

  // Exact.
  Areas areas_at(GridPoint p) const {
    return {turn(corners[1], corners[2], p), turn(corners[2], corners[0], p), turn(corners[0], corners[1], p)};
  }
  double height_m_at(const Areas& areas) const {
    // whole numbers below 2^62, and the point is inside: their sum is exact
    const auto area = static_cast<double>(areas[0] + areas[1] + areas[2]);
    const double s = static_cast<double>(areas[1]) / area, t = static_cast<double>(areas[2]) / area;
    return heights[0].z + s * (heights[1].z - heights[0].z) + t * (heights[2].z - heights[0].z);
  }
};

// Evaluates all three without branches, which could not be predicted.
bool is_strictly_inside(const Areas& areas) {
  return static_cast<int>(areas[0] > 0) + static_cast<int>(areas[1] > 0) + static_cast<int>(areas[2] > 0) == 3;
}

}  // namespace

Reference reference_of(Delaunay&& triangulation, std::vector<Heights>&& heights, const Box2& cell) {
  assert(heights.size() == triangulation.vertices().size());
  PointBuckets buckets = bucket_points(triangulation.vertices(), grid_point(cell.min), grid_point(cell.max));
  std::vector<std::uint32_t> first = first_faces(triangulation);
  Reference reference{
      std::move(triangulation), std::move(heights), cell, std::move(buckets), std::move(first), {}, nullptr};
  reference.centre_faces = faces_at_centres(reference);
  return reference;
}

Reference reference_of(const map::Heightfield& terrain, const Box2& cell) {
  return {Delaunay({}, {}), {}, cell, {}, {}, {}, &terrain};
}

double height_m_at(const Reference& reference, Vec2 p, HeightLayer layer) {
  if (reference.terrain != nullptr) return map::height_m_at(*reference.terrain, p);
  const Vec2 inside{std::clamp(p.x, reference.cell.min.x, reference.cell.max.x),
                    std::clamp(p.y, reference.cell.min.y, reference.cell.max.y)};
  const FinePoint fine = fine_point(inside);
  const DelaunayFace& face = reference.triangulation.faces()[face_at(reference, fine, grid_point(inside))];
  return height_in_face(reference, face, in_face(reference, face, fine), fine, layer);
}

Place place_at(const Reference& reference, Vec2 p) {
  assert(reference.cell.contains(p));
  return {p, reference.terrain != nullptr ? kNoFace : face_at(reference, fine_point(p), grid_point(p))};
}

Heights heights_at(const Reference& reference, const Place& place) {
  assert((place.face == kNoFace) == (reference.terrain != nullptr));
  Heights heights;
  if (reference.terrain != nullptr) {
    heights.fill(map::height_m_at(*reference.terrain, place.at));
    return heights;
  }
  const FinePoint fine = fine_point(place.at);
  const DelaunayFace& face = reference.triangulation.faces()[place.face];
  const InFace in = in_face(reference, face, fine);
  for (std::size_t layer = 0; layer < heights.size(); ++layer)
    heights[layer] = height_in_face(reference, face, in, fine, static_cast<HeightLayer>(layer));
  return heights;
}

WorstPoint worst_on_edge(const Reference& reference, Vec3 a, Vec3 b, HeightLayer layer) {
  return worst_on_edge(reference, EdgeEnd{a, place_at(reference, in_plan(a)).face},
                       EdgeEnd{b, place_at(reference, in_plan(b)).face}, layer);
}

WorstPoint worst_on_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer) {
  if (reference.terrain != nullptr) return worst_on_edge(*reference.terrain, a.at, b.at);
  // from the lower end, so that both faces of an edge find the same bits
  if (in_plan(b.at) < in_plan(a.at)) std::swap(a, b);
  const MeshEdge edge{a.at, b.at, grid_point(in_plan(a.at)), grid_point(in_plan(b.at))};
  WorstPoint worst;
  StraightWalk walk = walk_from_face(walk_ground(reference), a.face, fine_point(edge.from), fine_point(edge.to));
  for (WalkStep met = next(walk); !met.is_end(); met = next(walk)) {
    if (met.is_vertex())
      consider_vertex(worst, reference, edge, met.p, layer);
    else
      consider_crossing(worst, reference, edge, met, layer);
  }
  return worst;
}

WorstPoint worst_on_shared_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer) {
  const bool is_of_terrain = reference.terrain != nullptr && lies_along_border(reference.cell, a.at, b.at);
  return is_of_terrain ? worst_on_cell_border(*reference.terrain, a.at, b.at) : worst_on_edge(reference, a, b, layer);
}

WorstPoint worst_inside(const Reference& reference, const std::array<Vec3, 3>& corners, HeightLayer layer) {
  if (reference.terrain != nullptr) return worst_inside(*reference.terrain, corners);
  TrianglePlane plane{{}, corners};
  for (int i = 0; i < 3; ++i) plane.corners[i] = grid_point(in_plan(corners[i]));
  const auto& vertices = reference.triangulation.vertices();
  WorstPoint worst;
  any_near_triangle(reference.buckets, plane.corners, [&](std::uint32_t v) {
    const Areas areas = plane.areas_at(vertices[v]);
    if (is_strictly_inside(areas))
      consider(worst, std::abs(plane.height_m_at(areas) - height_of(reference, v, layer)), plane_point(vertices[v]));
    return false;
  });
  return worst;
}

std::array<Vec2, 4> corners_about(const Reference& reference, Vec2 p) {
  if (reference.terrain != nullptr) {
    const map::CellPosition in = map::cell_at(*reference.terrain, p);
    const auto corner = [&](int i, int j) { return reference.terrain->vertex(in.i + i, in.j + j); };
    return {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
  }
  const auto& vertices = reference.triangulation.vertices();
  const auto& v = reference.triangulation.faces()[place_at(reference, p).face].vertices;
  const Vec2 last = plane_point(vertices[v[2]]);
  return {plane_point(vertices[v[0]]), plane_point(vertices[v[1]]), last, last};
}

Vec2 nearest_vertex(const Reference& reference, Vec2 p) {
  if (reference.terrain != nullptr) return map::nearest_vertex(*reference.terrain, p);
  const auto& vertices = reference.triangulation.vertices();
  return plane_point(vertices[nearest_point_index(reference.buckets, vertices, grid_point(p))]);
}

}  // namespace citykiln::ground
