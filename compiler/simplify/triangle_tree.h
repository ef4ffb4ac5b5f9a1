// Finds the triangle nearest to a point, by a tree of boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"

namespace citykiln::simplify {

/// A triangle by its corners. It may be degenerate.
struct Corners {
  Vec3 a, b, c;
};

/// Returns the corners of all triangles of a mesh, in order.
std::vector<Corners> corners_of(const Mesh& mesh);

/// Returns the distance of a point from a closed triangle.
double distance_m(Vec3 p, const Corners& triangle);

/// Triangles in a tree of boxes.
class TriangleTree {
 public:
  struct Nearest {
    double distance_m;       ///< Infinite for a tree without triangles.
    std::uint32_t triangle;  ///< Its number in the tree's order.
  };

  /// Builds the tree, which has an order of its own of the triangles. O(n log n). It depends on the triangles and their
  /// order only.
  explicit TriangleTree(std::vector<Corners> triangles);

  bool is_empty() const { return triangles_.empty(); }
  /// Returns a triangle by its number in the tree's order, which is not that of the constructor's argument.
  const Corners& triangle(std::uint32_t i) const { return triangles_[i]; }

  /// Returns the triangle nearest to p. O(log n) for triangles spread evenly.
  /// @param guess  Any triangle of the tree, by its number; a near one makes the search faster.
  Nearest nearest(Vec3 p, std::uint32_t guess = 0) const;

 private:
  struct Node {
    Vec3 low, high;
    std::uint32_t first = 0, last = 0;  // of triangles
    std::uint32_t second = 0;           // the first child is the next node; 0: a leaf
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  void search(std::uint32_t at, Vec3 p, Nearest& best) const;

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace citykiln::simplify
