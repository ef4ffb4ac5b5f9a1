#include "compiler/geometry/triangles/straight_walk.h"

#include <cassert>
#include <cmath>

#include "compiler/contract/tolerance.h"

namespace citykiln {
namespace {

__extension__ using Wide = __int128;

FinePoint place(const StraightWalk& walk, std::uint32_t vertex) { return fine_point(walk.ground.vertices[vertex]); }

int corner_index(const DelaunayFace& face, std::uint32_t vertex) {
  return face.vertices[0] == vertex ? 0 : face.vertices[1] == vertex ? 1 : 2;
}

// The next face counter-clockwise about a vertex.
std::uint32_t turned_left(const DelaunayFace& face, std::uint32_t vertex) {
  return face.neighbours[(corner_index(face, vertex) + 1) % 3];
}

std::uint32_t turned_right(const DelaunayFace& face, std::uint32_t vertex) {
  return face.neighbours[(corner_index(face, vertex) + 2) % 3];
}

// True if b lies beyond w on the ray from v through w.
bool is_beyond(FinePoint v, FinePoint w, FinePoint b) {
  return Wide{w.x - v.x} * (b.x - w.x) + Wide{w.y - v.y} * (b.y - w.y) > 0;
}

// Moves from the walk's vertex along an edge to the vertex `end`.
WalkStep along_edge(StraightWalk& walk, std::uint32_t end) {
  if (!is_beyond(place(walk, walk.vertex), place(walk, end), walk.to)) return {};
  walk.vertex = end;
  return {end, end};
}

WalkStep through_vertex(StraightWalk& walk, std::uint32_t vertex) {
  walk.vertex = vertex;
  return {vertex, vertex};
}

// Moves across edge i of the walk's face; ends the walk at the triangulation's border.
WalkStep across_edge(StraightWalk& walk, int i) {
  const DelaunayFace& face = walk.ground.faces[walk.face];
  if (face.neighbours[i] == kNoFace) return {};
  walk.before = walk.face;
  walk.face = face.neighbours[i];
  walk.vertex = kNoVertex;
  return {face.vertices[(i + 1) % 3], face.vertices[(i + 2) % 3]};
}

WalkStep leave_vertex(StraightWalk& walk) {
  const std::uint32_t vertex = walk.vertex;
  const FinePoint v = place(walk, vertex);
  walk.face = walk.ground.first_faces[vertex];
  for (std::uint32_t f = walk.face;;) {
    const DelaunayFace& face = walk.ground.faces[f];
    const int i = corner_index(face, vertex);
    const std::uint32_t p = face.vertices[(i + 1) % 3], q = face.vertices[(i + 2) % 3];
    const int right = side_of(v, place(walk, p), walk.to), left = side_of(v, place(walk, q), walk.to);
    if (right >= 0 && left <= 0) {
      walk.face = f;
      if (right == 0) return along_edge(walk, p);
      if (left == 0) return along_edge(walk, q);
      return side_of(place(walk, p), place(walk, q), walk.to) >= 0 ? WalkStep{} : across_edge(walk, i);
    }
    f = turned_left(face, vertex);
    if (f == kNoFace || f == walk.face) return {};
  }
}

// The edge through which the walk leaves its face: the line passes it and the goal lies beyond it. -1: the goal is
// reached.
int way_out(const StraightWalk& walk) {
  const DelaunayFace& face = walk.ground.faces[walk.face];
  for (int i = 0; i < 3; ++i) {
    const FinePoint p = place(walk, face.vertices[(i + 1) % 3]), q = place(walk, face.vertices[(i + 2) % 3]);
    const bool leads_on =
        side_of(p, q, walk.to) < 0 && side_of(walk.from, walk.to, p) <= 0 && side_of(walk.from, walk.to, q) >= 0;
    if (leads_on) return i;
  }
  return -1;
}

// After crossing an edge, its ends lie on either side of the line, so the side of the third corner decides through
// which of the other two edges the walk leaves.
WalkStep leave_crossed(StraightWalk& walk) {
  const DelaunayFace& face = walk.ground.faces[walk.face];
  const int tip = face.neighbours[0] == walk.before ? 0 : face.neighbours[1] == walk.before ? 1 : 2;
  const std::uint32_t r = face.vertices[tip], left = face.vertices[(tip + 1) % 3], right = face.vertices[(tip + 2) % 3];
  const int side = side_of(walk.from, walk.to, place(walk, r));
  const bool is_left_out = side <= 0 && side_of(place(walk, r), place(walk, left), walk.to) < 0;
  const bool is_right_out = side >= 0 && side_of(place(walk, right), place(walk, r), walk.to) < 0;
  if (!is_left_out && !is_right_out) return {};
  if (side == 0) return through_vertex(walk, r);
  return across_edge(walk, (tip + (is_left_out ? 2 : 1)) % 3);
}

WalkStep leave_face(StraightWalk& walk) {
  if (walk.before != kNoFace) return leave_crossed(walk);
  for (;;) {
    const int i = way_out(walk);
    if (i < 0) return {};
    const DelaunayFace& face = walk.ground.faces[walk.face];
    const std::uint32_t p = face.vertices[(i + 1) % 3], q = face.vertices[(i + 2) % 3];
    if (side_of(walk.from, walk.to, place(walk, p)) == 0) return through_vertex(walk, p);
    if (side_of(walk.from, walk.to, place(walk, q)) == 0) return through_vertex(walk, q);
    // an edge on which the walk starts is not reported
    const bool starts_here = side_of(place(walk, p), place(walk, q), walk.from) == 0;
    const WalkStep met = across_edge(walk, i);
    if (met.is_end() || !starts_here) return met;
    return leave_crossed(walk);
  }
}

}  // namespace

FinePoint fine_point(Vec2 p) {
  constexpr double kSteps = (1 << kFineStepsLog2) / kQuantum_m;
  return {static_cast<std::int64_t>(std::floor(p.x * kSteps + 0.5)),
          static_cast<std::int64_t>(std::floor(p.y * kSteps + 0.5))};
}

int side_of(FinePoint a, FinePoint b, FinePoint c) {
  const Wide left = Wide{b.x - a.x} * (c.y - a.y), right = Wide{b.y - a.y} * (c.x - a.x);
  return left > right ? 1 : left < right ? -1 : 0;
}

std::vector<std::uint32_t> first_faces(const Delaunay& triangulation) {
  const std::vector<DelaunayFace>& faces = triangulation.faces();
  std::vector<std::uint32_t> first(triangulation.vertices().size(), kNoFace);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (const std::uint32_t v : faces[f].vertices)
      if (first[v] == kNoFace || turned_right(faces[f], v) == kNoFace) first[v] = f;
  return first;
}

StraightWalk walk_from_vertex(const TriangulationView& ground, std::uint32_t vertex, FinePoint to) {
  assert(vertex < ground.vertices.size() && ground.first_faces.size() == ground.vertices.size());
  return {ground, fine_point(ground.vertices[vertex]), to, ground.first_faces[vertex], vertex};
}

StraightWalk walk_from_face(const TriangulationView& ground, std::uint32_t face, FinePoint from, FinePoint to) {
  assert(face < ground.faces.size());
  StraightWalk walk{ground, from, to, face, kNoVertex};
  for (const std::uint32_t v : ground.faces[face].vertices)
    if (place(walk, v) == from) walk.vertex = v;
  return walk;
}

WalkStep next(StraightWalk& walk) { return walk.vertex == kNoVertex ? leave_face(walk) : leave_vertex(walk); }

}  // namespace citykiln
