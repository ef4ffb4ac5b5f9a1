// The reference: the graded terrain of one cell at full detail, linear on every face of one triangulation, one height
// per layer. Coarser meshes are measured against it as against the terrain (height_error.h): the largest vertical
// distance lies at a vertex of the overlay, so evaluating those is exact.
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/delaunay.h"
#include "compiler/geometry/point_buckets.h"
#include "compiler/ground/height_layer.h"
#include "compiler/ground/mesh/height_error.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

/// Without grading the reference is the terrain, the same on all layers: then `terrain` is set and the rest is empty.
struct Reference {
  Delaunay triangulation;
  std::vector<Heights> heights;               ///< One per vertex.
  Box2 cell;                                  ///< The area of the triangulation.
  PointBuckets buckets;                       ///< Of the vertices.
  std::vector<std::uint32_t> first_faces;     ///< One per vertex (geometry/straight_walk.h).
  std::vector<std::uint32_t> centre_faces;    ///< One per bucket: the face at its centre, where walks to a place start.
  const map::Heightfield* terrain = nullptr;  ///< Not owned.
};

/// Makes a reference of a triangulation.
/// @param triangulation  Covers the cell exactly. It need not be Delaunay.
/// @param heights        One per vertex.
/// O(n).
Reference reference_of(Delaunay&& triangulation, std::vector<Heights>&& heights, const Box2& cell);

/// Makes a reference of terrain without grading.
/// @param terrain  Must outlive the reference. O(1).
Reference reference_of(const map::Heightfield& terrain, const Box2& cell);

/// Returns the height at p, moved into the closed cell first. At a vertex exactly its height; on an edge a function of
/// the edge alone, hence the same from both sides and in both cells of a border. O(1) expected.
double height_m_at(const Reference& reference, Vec2 p, HeightLayer layer);

/// A place of a mesh and the reference's face that holds it, found once for all edges that start there.
struct Place {
  Vec2 at;
  std::uint32_t face = kNoFace;  ///< kNoFace where the reference is the terrain.
};

/// Finds the face at p, in the closed cell. O(1) expected.
Place place_at(const Reference& reference, Vec2 p);

/// Returns height_m_at() for all layers, bit for bit. O(1).
Heights heights_at(const Reference& reference, const Place& place);

/// Returns the largest error along an edge from a to b (on the 2^-10 m grid, in the closed cell), without its ends: at
/// its crossings with edges of the reference and at vertices on it. The same from b to a. O(faces crossed).
WorstPoint worst_on_edge(const Reference& reference, Vec3 a, Vec3 b, HeightLayer layer);

/// An end of an edge with known face.
struct EdgeEnd {
  Vec3 at;
  std::uint32_t face;  ///< As in Place.
};
WorstPoint worst_on_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// Returns the largest error along an edge; for edges on the cell's border bit for bit the same in both cells, whether
/// graded or not: the terrain is evaluated where a triangulation would have vertices, up to half a grid step off its
/// diagonals. Borders are split by this function; errors are measured by worst_on_edge().
WorstPoint worst_on_shared_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// Returns the largest error at vertices of the reference inside a triangle (in plan, counter-clockwise, corners on the
/// 2^-10 m grid), without its edges. O(vertices in the buckets it touches).
WorstPoint worst_inside(const Reference& reference, const std::array<Vec3, 3>& corners, HeightLayer layer);

/// Returns the corners of the piece that holds p: a rectangle of the terrain, or a face with its last corner twice.
/// O(1) expected.
std::array<Vec2, 4> corners_about(const Reference& reference, Vec2 p);

/// Returns the place of the reference's vertex nearest to p; of equals the first by place. O(1) expected.
Vec2 nearest_vertex(const Reference& reference, Vec2 p);

}  // namespace citykiln::ground
