// The reference of a cell: the graded terrain at full detail, linear on every face of one triangulation, with one
// height per vertex and height layer (height_layer.h). The error of a coarser mesh is its largest vertical distance
// from the reference. The largest distance is at a vertex of the overlay of both triangulations, so comparing these
// vertices is exact.
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/point_buckets.h"
#include "compiler/geometry/triangles/delaunay.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/mesh/height_error.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The reference of a cell. Without grading it is the terrain, on all layers: `terrain` is set, and the rest is empty.
struct Reference {
  Delaunay triangulation;
  std::vector<Heights> heights;               ///< One per vertex.
  Box2 cell;                                  ///< The area of the triangulation.
  PointBuckets buckets;                       ///< Index of the vertices.
  std::vector<std::uint32_t> first_faces;     ///< One per vertex (geometry/triangles/straight_walk.h).
  std::vector<std::uint32_t> centre_faces;    ///< One per bucket: the face at its centre, where walks to a place start.
  const map::Heightfield* terrain = nullptr;  ///< Not owned.
};

/// Makes a reference of a triangulation.
/// @param triangulation  A triangulation that covers the cell exactly. It need not be Delaunay.
/// @param heights        One per vertex.
/// O(n).
Reference reference_of(Delaunay&& triangulation, std::vector<Heights>&& heights, const Box2& cell);

/// Makes a reference of terrain without grading. O(1).
/// @param terrain  Must outlive the reference.
Reference reference_of(const map::Heightfield& terrain, const Box2& cell);

/// Returns the height at p, which is moved into the closed cell first. Exact at vertices. On an edge the height depends
/// on the edge only, so it is equal from both sides, and in both cells of a border. O(1) expected.
double height_m_at(const Reference& reference, Vec2 p, HeightLayer layer);

/// A place, and the face of the reference that contains it. Storing the face saves searching it again.
struct Place {
  Vec2 at;
  std::uint32_t face = kNoFace;  ///< kNoFace if the reference is the terrain.
};

/// Finds the face at p, which must lie in the closed cell. O(1) expected.
Place place_at(const Reference& reference, Vec2 p);

/// Returns height_m_at() for all layers. O(1).
Heights heights_at(const Reference& reference, const Place& place);

/// Returns the point with the largest error along an edge from a to b (on the 2^-10 m grid, in the closed cell),
/// without its ends. Errors are measured where the edge crosses edges of the reference or passes its vertices. Both
/// directions give the same result. O(faces crossed).
WorstPoint worst_on_edge(const Reference& reference, Vec3 a, Vec3 b, HeightLayer layer);

/// An end of an edge, with its face.
struct EdgeEnd {
  Vec3 at;
  std::uint32_t face;  ///< Place::face of the end.
};
WorstPoint worst_on_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// Returns the point with the largest error along an edge on the cell's border, such that both cells get equal bits,
/// whether graded or not: terrain is evaluated at the vertices that a triangulation of it would have, up to half a grid
/// step off its diagonals. Splitting of borders uses this function; worst_on_edge() measures errors.
WorstPoint worst_on_shared_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// Returns the point with the largest error among the reference's vertices inside a triangle (in plan,
/// counter-clockwise, corners on the 2^-10 m grid), without its edges. O(vertices in the buckets it touches).
WorstPoint worst_inside(const Reference& reference, const std::array<Vec3, 3>& corners, HeightLayer layer);

/// Returns the corners of the part of the reference that contains p and is linear: a square of the terrain's grid, or a
/// face with its last corner repeated. O(1) expected.
std::array<Vec2, 4> corners_about(const Reference& reference, Vec2 p);

/// Returns the place of the reference's vertex nearest to p; on a tie the first one by place. O(1) expected.
Vec2 nearest_vertex(const Reference& reference, Vec2 p);

}  // namespace citykiln::ground
