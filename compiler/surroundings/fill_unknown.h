// Continues known heights to where no heightmap knows any.
#pragma once

#include <vector>

#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// At this distance from known ground half of what lies above or below the mean is left.
inline constexpr double kFillFade_m = 2000;

/// Gives each unknown vertex the height of the nearest known one of its row, or, in rows without any, that of the
/// nearest row, both fading into the mean of all known heights. Beside sea there is sea. O(n · columns).
/// @param known  One for each vertex, at least one of them true.
void fill_unknown(const std::vector<bool>& known, Surroundings& around);

}  // namespace citykiln::surroundings
