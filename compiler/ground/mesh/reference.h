// The graded terrain of one cell, as exact as it gets: heights that are linear on every face of one triangulation, a
// height a layer. Coarser meshes are measured against it as against the raw field (height_error.h): the largest
// vertical distance lies at a vertex of the overlay, so looking at those is exact.
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

/// Where nothing is carved that is the terrain, on all layers alike: then it is asked itself, and the rest is empty.
struct Reference {
  Delaunay triangulation;
  std::vector<Heights> heights;               ///< One a vertex.
  Box2 cell;                                  ///< What the triangulation covers.
  PointBuckets buckets;                       ///< Of the vertices.
  std::vector<std::uint32_t> first_faces;     ///< One a vertex (geometry/straight_walk.h).
  std::vector<std::uint32_t> centre_faces;    ///< One a bucket: what holds its centre. Walks to a place start there.
  const map::Heightfield* terrain = nullptr;  ///< Not owned.
};

/// @param triangulation  Covers the cell exactly. Only its faces count: a face may be Delaunay or not.
/// @param heights        One a vertex.
/// O(n).
Reference reference_of(Delaunay&& triangulation, std::vector<Heights>&& heights, const Box2& cell);

/// @param terrain  Must outlive the reference. O(1).
Reference reference_of(const map::Heightfield& terrain, const Box2& cell);

/// At a point of the closed cell; those outside are moved to its border. At a vertex exactly its height, on an edge a
/// function of the edge alone, so the same from both sides and in both cells of a border. O(1) expected.
double height_m_at(const Reference& reference, Vec2 p, HeightLayer layer);

/// A place of a mesh: its point, and the reference's face that holds it. Where many edges start from one place, that
/// face is looked for once.
struct Place {
  Vec2 at;
  std::uint32_t face = kNoFace;  ///< kNoFace where the reference is the terrain.
};

/// @param p  In the closed cell. O(1) expected.
Place place_at(const Reference& reference, Vec2 p);

/// To the bit what height_m_at gives for each layer. O(1).
Heights heights_at(const Reference& reference, const Place& place);

/// Along an edge from a to b (on the 2^-10 m grid, in the closed cell), ends left out: at its crossings with edges of
/// the reference, and at vertices it passes. The same from b to a. O(faces crossed).
WorstPoint worst_on_edge(const Reference& reference, Vec3 a, Vec3 b, HeightLayer layer);

/// The same, with what is known of the ends.
struct EdgeEnd {
  Vec3 at;
  std::uint32_t face;  ///< As in Place.
};
WorstPoint worst_on_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// The same, but for an edge on the cell's border: of that both cells find the same to the bit, whichever is carved. A
/// triangulation has the border's vertices there; the terrain itself is looked at where those are. Its diagonals cross
/// up to half a grid step off, so this is to cut by, and worst_on_edge to certify by.
WorstPoint worst_on_shared_edge(const Reference& reference, EdgeEnd a, EdgeEnd b, HeightLayer layer);

/// At the reference's vertices inside a triangle (in plan, counter-clockwise, corners on the 2^-10 m grid), its edges
/// left out. O(vertices in the buckets it touches).
WorstPoint worst_inside(const Reference& reference, const std::array<Vec3, 3>& corners, HeightLayer layer);

/// The corners of the piece that holds a point: the terrain's rectangle, or a face (its last corner twice). O(1)
/// expected.
std::array<Vec2, 4> corners_about(const Reference& reference, Vec2 p);

/// The place of the reference's vertex nearest to a point; of equals the first by place. O(1) expected.
Vec2 nearest_vertex(const Reference& reference, Vec2 p);

}  // namespace citykiln::ground
