// How far a rule moves the surface that it is given: the arithmetic of certified levels (README.md says why it is
// safe).
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// Bounds between an earlier surface A and what became of it, B. Metres; infinite where nothing is known.
struct Displacement {
  double out_m = 0;   ///< No point of B is farther than this from A.
  double back_m = 0;  ///< No point of A is farther than this from B.
  double largest_m() const { return out_m > back_m ? out_m : back_m; }
};

inline constexpr double kUnbounded_m = std::numeric_limits<double>::infinity();

/// First a, then b: A → B → C.
inline Displacement operator+(Displacement a, Displacement b) { return {a.out_m + b.out_m, a.back_m + b.back_m}; }

/// Every point p of the faces goes to an affine function of p, given by where it takes the vertices.
Displacement affine_displacement(std::span<const Face> from, std::span<const Face> to);

/// Any two surfaces that lie in the hulls of these points: no pair of points is farther apart than some pair of the
/// hulls' vertices. O(n m).
Displacement any_displacement(std::span<const Vec3> from, std::span<const Vec3> to);

Ring3 vertices_of(std::span<const Face> faces);

/// A successor, as its parent sees it.
struct ChildTrace {
  Displacement before;      ///< From the parent's surface to the shape out of which the child was taken.
  Displacement own;         ///< From the child's surface to what its derivation made of it.
  bool vanished = false;    ///< Its derivation made nothing of it (NIL, a component nobody asked for).
  std::uint32_t group = 0;  ///< The children of a group cover, together, the shape they were taken out of.
  bool filled = false;      ///< `vertices` are the ring of a face without holes.
  Ring3 vertices;           ///< If vanished: a hull of its surface. Else: some of the corners of one of its faces.
};

/// What a node's surfaces look like, of those that are wide enough to be told apart.
struct VisibleAppearances {
  enum class Count : std::uint8_t { kNone, kOne, kMany };
  Count count = Count::kNone;
  std::uint32_t look = 0;  ///< Of kOne.

  void add(VisibleAppearances more) {
    if (more.count == Count::kNone) return;
    const bool is_same = count == Count::kOne && more.count == Count::kOne && look == more.look;
    *this = count == Count::kNone || is_same ? more : VisibleAppearances{Count::kMany, 0};
  }
  bool are_many() const { return count == Count::kMany; }
  bool show_other_than(std::uint32_t one) const { return are_many() || (count == Count::kOne && look != one); }
};

/// What a node's derivation moves, and whether it makes nothing at all.
struct NodeTrace {
  Displacement moved;
  bool vanished = true;
  VisibleAppearances seen =
      {};  ///< Where looks are kept. If many, nobody asks for `moved`: the node and all around it stay.
};

/// Puts together what the children say.
///
/// out: a point of the result lies within own.out of its child's surface, which lies within before.out of the parent's.
/// back: a point of the parent lies within before.back of the shape a group was taken out of, thus of a point of one of
/// the group's children; that lies within own.back of what became of the child; or, if the child vanished, within the
/// distance to a convex face, or an edge, of a sibling that did not, and from there within that sibling's own.back. Any
/// one group will do, so the best counts. Distance to what is convex is convex: it is largest at a vertex of the
/// vanished hull. Of siblings those next to it among the children are looked at: any will do, and so the cost is
/// linear.
NodeTrace together(std::span<const ChildTrace> children);

}  // namespace citykiln::grammars
