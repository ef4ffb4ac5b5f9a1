// A walk through a triangulation along a straight line: what it meets, in order. From a vertex, it also finds the face
// that holds a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/delaunay.h"

namespace citykiln {

/// A point in units of 2^-30 m: as fine as a double of plane metres needs, so that tests about any place are exact.
struct FinePoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const FinePoint&) const = default;
};
inline constexpr int kFineStepsLog2 = 20;  ///< Of one step of the grid.

FinePoint fine_point(Vec2 p);
inline FinePoint fine_point(GridPoint p) { return {p.x << kFineStepsLog2, p.y << kFineStepsLog2}; }

/// Positive where a, b, c turn left, 0 on one line. Exact.
int side_of(FinePoint a, FinePoint b, FinePoint c);

/// For each vertex one face at it: the one from which turning counter-clockwise meets all others.
std::vector<std::uint32_t> first_faces(const Delaunay& triangulation);

/// What a walk goes through. Refers to a triangulation and its first_faces().
struct TriangulationView {
  std::span<const GridPoint> vertices;
  std::span<const DelaunayFace> faces;
  std::span<const std::uint32_t> first_faces;
};

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

struct StraightWalk {
  TriangulationView ground;
  FinePoint from, to;
  std::uint32_t face = kNoFace;      ///< Where it is; at its end the face that holds `to` (closed).
  std::uint32_t vertex = kNoVertex;  ///< Where it is at a vertex.
  std::uint32_t before = kNoFace;    ///< Not at a vertex: the face from which it has come across an edge, if it has.
};

StraightWalk walk_from_vertex(const TriangulationView& ground, std::uint32_t vertex, FinePoint to);
/// @param face  Holds `from` (closed).
StraightWalk walk_from_face(const TriangulationView& ground, std::uint32_t face, FinePoint from, FinePoint to);

/// An edge crossed between its ends (p to the walk's right, q to its left), or a vertex passed (p = q).
struct WalkStep {
  std::uint32_t p = kNoVertex, q = kNoVertex;
  bool is_end() const { return p == kNoVertex; }
  bool is_vertex() const { return p == q; }
};

/// Goes on to what the open line from `from` to `to` meets next; edges it runs along are not met, their ends are.
/// Where `to` lies outside the triangulation, the walk ends at the rim. O(1), at a vertex O(faces about it).
/// Ends in every triangulation, Delaunay or not. Source: Devillers, Pion, Teillaud, "Walking in a triangulation",
/// Internat. J. Found. Comput. Sci. 13, 2002 (the straight walk). All tests exact in 128 bits.
WalkStep next(StraightWalk& walk);

}  // namespace citykiln
