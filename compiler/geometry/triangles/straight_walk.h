// Walks through a triangulation along a straight line and reports the edges and vertices that it meets, in order. Also
// locates the face that contains a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/triangles/delaunay.h"

namespace citykiln {

/// A point in units of 2^-30 m (1 nm). Grid points convert exactly, other places are rounded; tests on fine points are
/// exact.
struct FinePoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const FinePoint&) const = default;
};
inline constexpr int kFineStepsLog2 = 20;  ///< log2 of the fine steps in one step of the grid.

/// Returns the fine point nearest to a point in plane metres.
FinePoint fine_point(Vec2 p);
inline FinePoint fine_point(GridPoint p) { return {p.x << kFineStepsLog2, p.y << kFineStepsLog2}; }

/// Returns a number with the sign of the turn a, b, c: positive to the left, 0 if the points are on one line. Exact.
int side_of(FinePoint a, FinePoint b, FinePoint c);

/// Returns for each vertex its clockwise-most face: from there, counter-clockwise steps reach all faces of the vertex.
std::vector<std::uint32_t> first_faces(const Delaunay& triangulation);

/// A triangulation and its first_faces(); refers to both.
struct TriangulationView {
  std::span<const GridPoint> vertices;
  std::span<const DelaunayFace> faces;
  std::span<const std::uint32_t> first_faces;
};

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// The state of a walk from `from` to `to`.
struct StraightWalk {
  TriangulationView ground;
  FinePoint from, to;
  /// The current face; at the end a face that contains `to` in its interior or on its border.
  std::uint32_t face = kNoFace;
  std::uint32_t vertex = kNoVertex;  ///< The current vertex, if the walk is at one.
  std::uint32_t before = kNoFace;    ///< The face before the last crossed edge, if the walk is not at a vertex.
};

/// Returns a walk from a vertex of the triangulation, before its first step.
StraightWalk walk_from_vertex(const TriangulationView& ground, std::uint32_t vertex, FinePoint to);
/// Returns a walk from any point, before its first step.
/// @param face  A face that contains `from` in its interior or on its border.
StraightWalk walk_from_face(const TriangulationView& ground, std::uint32_t face, FinePoint from, FinePoint to);

/// An edge that the walk crosses (p to its right, q to its left), a vertex on the line (p == q), or the end of the
/// walk.
struct WalkStep {
  std::uint32_t p = kNoVertex, q = kNoVertex;
  bool is_end() const { return p == kNoVertex; }
  bool is_vertex() const { return p == q; }
};

/// Advances to the next edge or vertex on the open line from `from` to `to`. An edge along the line is not reported,
/// but its ends are. If `to` lies outside the triangulation, the walk ends at its border. O(1), at a vertex O(its
/// faces). Terminates in every triangulation, Delaunay or not. Source: Devillers, Pion, Teillaud, "Walking in a
/// triangulation", Internat. J. Found. Comput. Sci. 13, 2002 (the straight walk). All tests are exact in 128 bits.
WalkStep next(StraightWalk& walk);

}  // namespace citykiln
