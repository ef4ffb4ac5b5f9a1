// How a length is divided: CGA's absolute, relative ' and floating ~ sizes, and repeats *.
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
  double size = 0;               ///< Metres; of kRelative a share of the whole length. Below zero is zero.
  std::uint32_t leaf = 0;        ///< Whose it is.
  std::vector<SizeItem> nested;  ///< Of kRepeat.
};

struct Interval {
  double from_m = 0, to_m = 0;
  std::uint32_t leaf = 0;
};

using Intervals = SmallVector<Interval, 8>;

/// A piece thinner than this is given to its neighbour.
inline constexpr double kSliver_m = 1e-6;

/// Divides 0 … length_m.
///
/// Absolute and relative sizes are kept; floating ones share what is left in proportion. A repeat takes what the others
/// leave at their own sizes, as many times as fits best (the nearest whole number; where nothing else could fill it,
/// once at least, cut at the end if need be); then all floating sizes, those in repeats too, stretch by the same
/// factor. A repeat without floating sizes is repeated as often as it fits, and once more, cut at the end, where
/// nothing else would fill the rest. Where absolute sizes are too long, those at the end are cut. ~0 takes what no
/// other size does. A repeat inside of a repeat fills its floating share anew.
///
/// Guarantees: intervals begin at 0, follow each other without gaps, and do not go beyond the length; with a floating
/// size they end at it, exactly. std::nullopt where there would be more than `most`. O(intervals).
std::optional<Intervals> intervals_of(std::span<const SizeItem> items, double length_m, std::size_t most);

}  // namespace citykiln::grammars
