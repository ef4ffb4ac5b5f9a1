// Merges pieces of a split before rules are applied to them: a piece no wider than the tolerance into a neighbour, and
// adjacent pieces that become the same terminal into one piece.
//
//   |  Wall  |Joint|  Wall  |  →  |          Wall           |      The joint would be narrower than the tolerance. It
//            ≤ tolerance                                           is neither derived nor cut out.
#pragma once

#include "grammars/derivation/execution.h"
#include "grammars/derivation/sizes.h"

namespace citykiln::grammars {

/// A slice: a piece that will be cut from the shape, with its index among all pieces of the split.
struct Slice {
  Interval interval;
  std::size_t index = 0, total = 0;
  std::uint32_t left_out = 0;  ///< The number of pieces before this slice that are left out.
};

/// The slices of a split.
struct Division {
  SmallVector<Slice, 8> slices;
  /// Bounds the Hausdorff distance between the results of the slices and the results of all pieces.
  double error_m = 0;
};

/// Returns a division with a slice for each interval.
Division divided(std::span<const Interval> intervals);

/// True if appearances are kept, nodes are pruned early, and displacement_bound() applies to the shape.
bool may_merge_narrow(const Run& run, const Shape& shape);

/// Leaves out runs of adjacent pieces that are together no wider than the tolerance. The piece before or after a run is
/// extended over it, the one with the smaller error, if displacement_bound() gives an error within the tolerance.
///
/// Error: let S be the surface of the piece before it is extended, s the surfaces of the pieces left out, D and d the
/// results of S and s, and D′ the result of S′ = S + s. Bounds do not depend on the width, so bounds of S hold for S′.
/// A point of D′ is within out(S) of S′, hence within out(S) + max(back(S), back(s)) of D + d. A point of D + d is
/// within max(out(S), out(s)) of S′, hence within max(out(S), out(s)) + back(S) of D′.
///
/// @param division  A result of divided().
/// @param selectors  By Interval::leaf.
Division merge_narrow_pieces(Execution& execution, Division division, std::span<const Selector* const> selectors);

/// True if nodes are pruned early and the shape is one planar face.
bool may_merge_terminals(const Run& run, const Shape& shape);

/// Joins adjacent pieces whose bodies are the same terminal, like `Wall.`. The surface does not change.
///
/// @param division  A result of divided() or merge_narrow_pieces().
/// @param selectors  By Interval::leaf.
Division merge_terminals(Division division, std::span<const Selector* const> selectors);

}  // namespace citykiln::grammars
