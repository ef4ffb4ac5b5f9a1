// A constrained Delaunay triangulation with numbered faces that takes further points. CGAL's headers stay in
// delaunay.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"

namespace citykiln {

/// The number of a face where there is none.
inline constexpr std::uint32_t kNoFace = 0xffffffffu;

/// A face of the triangulation. Vertices are counter-clockwise. Neighbour i and edge i lie opposite to vertex i.
struct DelaunayFace {
  std::array<std::uint32_t, 3> vertices{};
  std::array<std::uint32_t, 3> neighbours{kNoFace, kNoFace, kNoFace};
  std::array<bool, 3> is_constrained{};
};

/// A triangulation of which vertices and faces keep their numbers when points are inserted; faces change their corners.
/// A rectangle without points inside gets the diagonal from south-west to north-east.
class Delaunay {
 public:
  /// @param vertices  Distinct points. The edges of their convex hull must be in `edges`.
  /// @param edges     Pairs of vertices that meet at their ends only (as arrange() makes them).
  Delaunay(std::span<const GridPoint> vertices, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges);
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  const std::vector<GridPoint>& vertices() const;
  const std::vector<DelaunayFace>& faces() const;

  /// Returns the face that a new point at p would split (one of two if p is on an edge), searched from face `near`.
  /// kNoFace if p is a vertex, lies on a constrained edge, or lies outside.
  std::uint32_t face_to_split(GridPoint p, std::uint32_t near) const;

  /// Inserts a point into the face that face_to_split() found, as the last vertex. Returns the new and changed faces,
  /// all of which have that vertex as a corner.
  std::span<const std::uint32_t> insert(GridPoint p, std::uint32_t face);

  /// Flips edge i of a face, which must not be constrained; the quadrilateral of its two faces must be strictly convex.
  /// The result may not be a Delaunay triangulation; insert() restores this property around inserted points. Returns
  /// the two faces.
  std::span<const std::uint32_t> flip(std::uint32_t face, int i);

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace citykiln
