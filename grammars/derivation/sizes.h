// Divides a length as CGA's split does: by absolute, relative (') and floating (~) sizes and repeated groups (*).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grammars/language/syntax.h"
#include "grammars/shapes/small_vector.h"

namespace citykiln::grammars {

/// One entry of a split.
struct SizeItem {
  SizeKind kind = SizeKind::kAbsolute;
  double size = 0;               ///< Metres; for kRelative a share of the whole length. Negative sizes count as zero.
  std::uint32_t leaf = 0;        ///< A number of the caller, copied into Interval::leaf.
  std::vector<SizeItem> nested;  ///< The entries of a kRepeat.
};

/// A part of the length.
struct Interval {
  double from_m = 0, to_m = 0;
  std::uint32_t leaf = 0;
};

using Intervals = SmallVector<Interval, 8>;

/// A piece thinner than this is added to its neighbour.
inline constexpr double kSliver_m = 1e-6;

/// Divides the range 0 … length_m. Returns std::nullopt for more than `most` intervals. O(intervals).
///
/// 1. Absolute and relative sizes are kept. If their sum is longer than length_m, the last ones are cut.
/// 2. A repeated group gets an equal share of the length that the other entries leave at their own sizes. It is
/// repeated the number of times that fits best: the nearest whole number, but no more than its fixed sizes allow, and
/// at least once if nothing else could fill the length.
/// 3. A group without floating sizes is repeated as often as it fits, and once more, cut at the end, if nothing else
/// would fill the rest.
/// 4. All floating sizes, also those in groups, are scaled by one factor to fill the rest. ~0 gets the length that no
/// other size takes.
/// 5. A group nested in a group divides its scaled length anew.
///
/// Guarantees: intervals begin at 0, are contiguous, and end at length_m or before; with a floating size the last
/// interval ends exactly at length_m.
std::optional<Intervals> intervals_of(std::span<const SizeItem> items, double length_m, std::size_t most);

}  // namespace citykiln::grammars
