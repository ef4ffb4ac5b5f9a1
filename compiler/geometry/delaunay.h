// A constrained Delaunay triangulation that takes further points, seen as numbered faces. CGAL does the work; its
// headers stay in delaunay.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"

namespace citykiln {

inline constexpr std::uint32_t kNoFace = 0xffffffffu;

/// Counter-clockwise. Neighbour i and edge i lie opposite to vertex i.
struct DelaunayFace {
  std::array<std::uint32_t, 3> vertices{};
  std::array<std::uint32_t, 3> neighbours{kNoFace, kNoFace, kNoFace};
  std::array<bool, 3> is_constrained{};
};

/// Vertices and faces keep their numbers; faces change their corners as points come in. Of a rectangle with nothing in
/// it, the diagonal from south-west to north-east is an edge.
class Delaunay {
 public:
  /// @param vertices  Different points.
  /// @param edges     Pairs of vertices. They must not cross or touch but at their ends (arrange() sees to it), and
  /// their hull must be convex.
  Delaunay(std::span<const GridPoint> vertices, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges);
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  const std::vector<GridPoint>& vertices() const;
  const std::vector<DelaunayFace>& faces() const;

  /// The face that a new point at p would split (one of two on an edge), searched from face `near`; kNoFace where p is
  /// a vertex already, lies on a constrained edge, or outside.
  std::uint32_t face_to_split(GridPoint p, std::uint32_t near) const;

  /// Puts a point into the face that face_to_split found. Returns the faces that changed or are new, all about the new
  /// vertex (the last one).
  std::span<const std::uint32_t> insert(GridPoint p, std::uint32_t face);

  /// Turns edge i of a face round, between the other two corners of the quadrilateral about it. That must be strictly
  /// convex, and the edge not constrained. It need not be Delaunay then; insert() makes it so again about what it puts
  /// in. Returns the two faces, which changed.
  std::span<const std::uint32_t> flip(std::uint32_t face, int i);

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace citykiln
