// Extrapolates known heights to vertices that no heightmap covers.
#pragma once

#include <vector>

#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// At this distance from a known vertex, half of its difference from the mean height is left.
inline constexpr double kFillFade_m = 2000;

/// Gives each unknown vertex the height of the nearest known vertex of its row, or of the nearest row that has one,
/// faded into the mean of all known heights. If that known vertex is sea, so is the unknown one. O(n · columns).
/// @param known  One value for each vertex; at least one is true.
void fill_unknown(const std::vector<bool>& known, Surroundings& around);

}  // namespace citykiln::surroundings
