// Bounds of how far rules move a surface; grammars/README.md ("Levels of detail") derives them.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// Bounds of the two one-sided Hausdorff distances between an earlier surface A and a later surface B. Metres; infinite
/// if unknown.
struct Displacement {
  double out_m = 0;   ///< No point of B is farther than this from A.
  double back_m = 0;  ///< No point of A is farther than this from B.
  double largest_m() const { return out_m > back_m ? out_m : back_m; }
};

inline constexpr double kUnbounded_m = std::numeric_limits<double>::infinity();

/// First a, then b: A → B → C. By the triangle inequality.
inline Displacement operator+(Displacement a, Displacement b) { return {a.out_m + b.out_m, a.back_m + b.back_m}; }

/// For an affine map of the faces, given by the images of the vertices: the largest distance that a vertex moves.
Displacement affine_displacement(std::span<const Face> from, std::span<const Face> to);

/// For any two surfaces within the convex hulls of these points: the largest distance between two points. O(n m).
Displacement any_displacement(std::span<const Vec3> from, std::span<const Vec3> to);

Ring3 vertices_of(std::span<const Face> faces);

/// A successor, as its parent sees it.
struct ChildTrace {
  Displacement before;      ///< From the parent's surface to the shape out of which the child was taken.
  Displacement own;         ///< From the child's surface to the result of its derivation.
  bool vanished = false;    ///< The result is empty (NIL, or a component that no selector takes).
  std::uint32_t group = 0;  ///< The union of the children of a group is the shape they were taken out of.
  bool filled = false;      ///< `vertices` are the ring of a face without holes.
  Ring3 vertices;  ///< If vanished: points whose hull contains its surface. Else: the first ring of the surface.
};

/// The appearances in the result of a node, of terminals wider than the tolerance.
struct VisibleAppearances {
  enum class Count : std::uint8_t { kNone, kOne, kMany };
  Count count = Count::kNone;
  std::uint32_t appearance = 0;  ///< Of kOne.

  void add(VisibleAppearances more) {
    if (more.count == Count::kNone) return;
    const bool is_same = count == Count::kOne && more.count == Count::kOne && appearance == more.appearance;
    *this = count == Count::kNone || is_same ? more : VisibleAppearances{Count::kMany, 0};
  }
  bool are_many() const { return count == Count::kMany; }
  bool include_other_than(std::uint32_t one) const { return are_many() || (count == Count::kOne && appearance != one); }
};

/// What the derivation of a node moves, and whether its result is empty.
struct NodeTrace {
  Displacement moved = {};
  bool vanished = true;
  VisibleAppearances seen =
      {};  ///< If there are many, `moved` is not used: neither the node nor its ancestors simplify.
};

/// The trace of a node from those of its children.
///
/// out: a point of the result is within own.out of its child's surface, which is within before.out of the parent's.
/// back: a point of the parent is within before.back of the shape a group was taken out of, hence of a point of one of
/// the group's children. That point is within own.back of the child's result. If the child vanished, it is within its
/// distance to a convex face or an edge of a sibling that did not, and from there within own.back of the sibling's
/// result. The distance to a convex set is convex, so it is largest at a vertex of the vanished child's hull. Every
/// group gives a bound, so the smallest is taken, and the same holds for siblings. Only the 256 siblings before and
/// after are tried, which keeps the cost linear.
NodeTrace combine(std::span<const ChildTrace> children);

}  // namespace citykiln::grammars
