// A limit along a road, known at every step, as few pinches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The pinches whose limit is nowhere above the one given, and below it by at most kSlack_units.
///
/// Method: from each pinch on to the farthest that can follow: the bottom of the next dip, if the limit does nothing
/// but open and close in between; else the end of the longest straight line that fits below. Blocks of the way are done
/// by themselves.
///
/// @param limit  Units of kUnit_m at each step of kStep_m, neighbours at most one unit apart.
/// @param whole  From here on the limit says nothing.
/// @param first  The first step's number along the whole way.
///
/// Exact at the first and the last step. None where the limit says nothing. What is said of a block depends on its own
/// steps alone. O(n) times the lines' lengths at worst, O(n) as a rule.
std::vector<WidthLimit> fit_width_limits(std::span<const std::int16_t> limit, int whole, std::int32_t first);

/// 12 cm: less than one sees of a pavement's edge that should follow a wall.
inline constexpr int kSlack_units = 4;

/// 64 m: a pinch more each block, so that what is decided here does not depend on the other end of a long row of
/// houses.
inline constexpr int kBlock_steps = 256;

}  // namespace citykiln::roads
