// Approximates a width limit, which is sampled at every step along a road, by a few limit points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns limit points whose interpolation is nowhere above the sampled limit and at most kSlack_units below it.
///
/// Method: from each point, the next one is the farthest possible. If the limit only widens and narrows by kTaper up to
/// the bottom of the next dip, it is this bottom; else it is the end of the longest straight line that fits below the
/// limit. Blocks of kBlock_steps are fitted independently, so that each result depends on its own block only.
///
/// @param limit  The limit at each step of kStep_m, in units of kUnit_m; neighbours differ by at most one.
/// @param whole  The full width, in units of kUnit_m; values at or above it are no limit.
/// @param first  The number of the first step, counted along the whole way.
///
/// Exact at the first and the last step. Empty if there is no limit. O(n) as a rule, times the lengths of the lines at
/// worst.
std::vector<WidthLimit> fit_width_limits(std::span<const std::int16_t> limit, int whole, std::int32_t first);

/// The largest deviation below the limit: 12 cm, invisible on a pavement's edge along a wall.
inline constexpr int kSlack_units = 4;

/// The length of a block: 64 m, so that the limits along a long row of houses depend on nearby houses only. It costs
/// one more point per block.
inline constexpr int kBlock_steps = 256;

}  // namespace citykiln::roads
