// Walks through a triangulation along a straight line and reports what it meets, in order. Also locates the face that
// contains a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/delaunay.h"

namespace citykiln {

/// A point in units of 2^-30 m, fine enough for any double in plane metres, so that tests are exact.
struct FinePoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const FinePoint&) const = default;
};
inline constexpr int kFineStepsLog2 = 20;  ///< Fine steps in one step of the grid.

FinePoint fine_point(Vec2 p);
inline FinePoint fine_point(GridPoint p) { return {p.x << kFineStepsLog2, p.y << kFineStepsLog2}; }

/// Positive for a left turn a, b, c; 0 on one line. Exact.
int side_of(FinePoint a, FinePoint b, FinePoint c);

/// For each vertex the face from which turning counter-clockwise reaches all other faces of the vertex.
std::vector<std::uint32_t> first_faces(const Delaunay& triangulation);

/// A triangulation and its first_faces(); refers to both.
struct TriangulationView {
  std::span<const GridPoint> vertices;
  std::span<const DelaunayFace> faces;
  std::span<const std::uint32_t> first_faces;
};

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

struct StraightWalk {
  TriangulationView ground;
  FinePoint from, to;
  std::uint32_t face = kNoFace;      ///< The present face; at the end a face that contains `to` (closed).
  std::uint32_t vertex = kNoVertex;  ///< The present vertex, if the walk is at one.
  std::uint32_t before = kNoFace;    ///< The face before the last crossed edge, if the walk is not at a vertex.
};

StraightWalk walk_from_vertex(const TriangulationView& ground, std::uint32_t vertex, FinePoint to);
/// @param face  Contains `from` (closed).
StraightWalk walk_from_face(const TriangulationView& ground, std::uint32_t face, FinePoint from, FinePoint to);

/// A crossed edge (p to the right of the walk, q to its left), or a vertex on the line (p = q), or the end.
struct WalkStep {
  std::uint32_t p = kNoVertex, q = kNoVertex;
  bool is_end() const { return p == kNoVertex; }
  bool is_vertex() const { return p == q; }
};

/// Advances to the next edge or vertex on the open line from `from` to `to`. Edges along the line are not reported,
/// their ends are. If `to` lies outside the triangulation, the walk ends at its border. O(1), at a vertex O(faces of
/// it). Terminates in every triangulation, Delaunay or not. Source: Devillers, Pion, Teillaud, "Walking in a
/// triangulation", Internat. J. Found. Comput. Sci. 13, 2002 (the straight walk). All tests are exact in 128 bits.
WalkStep next(StraightWalk& walk);

}  // namespace citykiln
