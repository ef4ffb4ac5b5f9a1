// Fits a few limit points to a limit that is sampled at every step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns limit points whose interpolation is nowhere above the sampled limit and at most kSlack_units below it.
///
/// Method: from each point to the farthest that can follow. That is the bottom of the next dip, if the limit only opens
/// and closes in between; else the end of the longest straight line that fits below. Blocks of kBlock_steps are fitted
/// independently, so that a result depends on its own block alone.
///
/// @param limit  Units of kUnit_m at each step of kStep_m; neighbours differ by at most one.
/// @param whole  The full width: at or above it there is no limit.
/// @param first  The number of the first step along the whole way.
///
/// Exact at the first and the last step. Nothing where there is no limit. O(n) as a rule, times the lengths of the
/// lines at worst.
std::vector<WidthLimit> fit_width_limits(std::span<const std::int16_t> limit, int whole, std::int32_t first);

/// 12 cm: invisible on a pavement's edge along a wall.
inline constexpr int kSlack_units = 4;

/// 64 m, at the cost of one more point a block: a long row of houses is decided in local parts.
inline constexpr int kBlock_steps = 256;

}  // namespace citykiln::roads
