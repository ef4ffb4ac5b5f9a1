// Upper bounds of the distance by which rules move a surface, computed from the children of a derivation node up to the
// node itself. A node is one application of a rule to a shape; its children are the shapes to which it applies further
// rules. grammars/cga.md ("Levels of detail") derives the bounds.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// Upper bounds of the two one-sided Hausdorff distances between an earlier surface A and a later surface B, in metres;
/// infinite if unknown.
struct Displacement {
  double to_earlier_m = 0;  ///< No point of B is farther than this from A.
  double to_later_m = 0;    ///< No point of A is farther than this from B.
  double largest_m() const { return to_earlier_m > to_later_m ? to_earlier_m : to_later_m; }
};

inline constexpr double kUnbounded_m = std::numeric_limits<double>::infinity();

/// Returns the displacement of a followed by b, A → B → C, by the triangle inequality.
inline Displacement operator+(Displacement a, Displacement b) {
  return {a.to_earlier_m + b.to_earlier_m, a.to_later_m + b.to_later_m};
}

/// Returns the displacement of an affine map of faces: the largest distance between a vertex and its image.
Displacement affine_displacement(std::span<const Face> from, std::span<const Face> to);

/// Returns a displacement that bounds any two surfaces within the convex hulls of these points: the largest distance
/// between a point of each. O(n m).
Displacement any_displacement(std::span<const Vec3> from, std::span<const Vec3> to);

/// Returns the vertices of all rings of the faces.
Ring3 vertices_of(std::span<const Face> faces);

/// Returns the largest distance of the points from the face that the ring bounds, if it is convex and `filled`, or from
/// one of the ring's edges. Results of at least `enough_m` may be too small.
double farthest_from_ring_m(std::span<const Vec3> points, std::span<const Vec3> ring, bool filled, double enough_m);

/// The displacements and extent of a child, from which combine() computes the parent's.
struct ChildTrace {
  Displacement before;      ///< From the parent's surface to the shape from which the child was cut.
  Displacement own;         ///< From the child's surface to the result of its derivation.
  bool vanished = false;    ///< The result is empty: NIL, or a component that no selector takes.
  std::uint32_t group = 0;  ///< Children with equal numbers were cut from one shape and together cover that shape.
  bool filled = false;      ///< `vertices` are the outer ring of a face without holes.
  /// If vanished: points whose convex hull contains the child's surface. Else: the first ring of that surface.
  Ring3 vertices;
};

/// The appearances of those terminals in a node's result that are wider than the tolerance.
struct VisibleAppearances {
  enum class Count : std::uint8_t { kNone, kOne, kMany };
  Count count = Count::kNone;
  std::uint32_t appearance = 0;  ///< The appearance if count is kOne: an index into Derivation::appearances.

  /// Adds the appearances of another result.
  void add(VisibleAppearances more) {
    if (more.count == Count::kNone) return;
    const bool is_same = count == Count::kOne && more.count == Count::kOne && appearance == more.appearance;
    *this = count == Count::kNone || is_same ? more : VisibleAppearances{Count::kMany, 0};
  }
  bool are_many() const { return count == Count::kMany; }
  bool include_other_than(std::uint32_t one) const { return are_many() || (count == Count::kOne && appearance != one); }
};

/// The displacement between a node's surface and its result, and the appearances of the result.
struct NodeTrace {
  Displacement moved = {};
  bool vanished = true;  ///< The result has no surface.
  /// With count kMany, `moved` is undefined: neither the node nor its ancestors are simplified.
  VisibleAppearances seen = {};
  double left_out_m = 0;  ///< The largest distance of a detail that was left out in the node (leave_out_details.h).
};

/// Returns the trace of a node from the traces of its children.
///
/// to_earlier_m: a point of the result is within own.to_earlier_m of its child's surface, which is within
/// before.to_earlier_m of the parent's.
/// to_later_m: a point of the parent is within before.to_later_m of the shape from which a group was cut, hence of a
/// point of one of the group's children, which is within own.to_later_m of the child's result. If that child vanished,
/// the point is within some distance of a convex face or an edge of a sibling that did not, and from there within
/// own.to_later_m of the sibling's result. The distance to a convex set is convex, so it is largest at a vertex of the
/// vanished child's hull. Every group and every sibling gives a bound, so the smallest is taken. Only the 256 siblings
/// before and after are tried, which keeps the cost linear.
NodeTrace combine(std::span<const ChildTrace> children);

}  // namespace citykiln::grammars
