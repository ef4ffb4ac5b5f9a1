// Pieces of a split that need not be made: what is no wider than the tolerance goes to its neighbour, and neighbours
// that end at once, all under one name, are one.
//
//   |  Wall  |Joint|  Wall  |  →  |          Wall           |      The joint's look would be under a pixel wide. It
//            ≤ tolerance                                           need not be derived, and nothing is sawn there.
#pragma once

#include "grammars/derivation/run.h"
#include "grammars/derivation/sizes.h"

namespace citykiln::grammars {

/// A piece that is sawn off, with the place that it has among all.
struct Slice {
  Interval interval;
  std::size_t index = 0, total = 0;
  std::uint32_t left_out = 0;  ///< Pieces before it that are not made.
};

struct Division {
  SmallVector<Slice, 8> slices;
  double error_m =
      0;  ///< Between what is made of the slices and what all pieces would have become, Hausdorff, both ways.
};

/// Every piece as it is.
Division divided(std::span<const Interval> intervals);

/// True if looks are kept, what is known ahead is used, and the shape is one of which things are known.
bool may_widen(const Run& run, const Shape& shape);

/// Neighbouring pieces that are together no wider than the tolerance are left out, and the one before or behind them
/// takes their place, whichever errs less, if the rules alone bound what becomes of it and of them.
///
/// Let a piece's surface be S, what its rules make of it D. No point of D is farther from S than `out`, none of S
/// farther from D than `back` (reach.h), however wide S is and however coarse D: so neither is D′, which is made of
/// S′ = S + the surfaces s of those left out. Of D′ a point is within out(S) of S′, thus within
/// out(S) + max(back(S), back(s)) of what would be there; of that a point is within max(out(S), out(s)) of S′, thus
/// within max(out(S), out(s)) + back(S) of D′.
///
/// @param division  As divided() made it.
/// @param selectors  By Interval::leaf.
Division merge_narrow_pieces(Execution& execution, Division division, std::span<const Selector* const> selectors);

/// True if what is known ahead is used, and the shape is one whose pieces have no ends of their own.
bool may_join(const Run& run, const Shape& shape);

/// Of neighbouring pieces of whose bodies nothing is left but the same terminal, like `Wall.`, the first takes the
/// place of all. The surface stays what it was.
///
/// @param division  As divided() or widened() made it.
/// @param selectors  By Interval::leaf.
Division join_terminals(Division division, std::span<const Selector* const> selectors);

}  // namespace citykiln::grammars
