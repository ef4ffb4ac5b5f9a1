// Decides which mapped kerbs (barrier=kerb) need stones of their own.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

/// A mapped kerb is that of a street if most of it lies this near to the street's kerb: farther from the axis, and
/// nearer to it, in metres.
inline constexpr double kSameKerbOutside_m = 1, kSameKerbInside_m = 1.5;

/// Returns for each barrier whether it is a kerb that a street shows by its own edge: 70 % of it, by samples every 2 m,
/// lie near a kerb of one of the roads. O(kerbs · roads near).
std::vector<bool> kerbs_of_streets(std::span<const map::Barrier> barriers, std::span<const roads::Road> roads);

}  // namespace citykiln::props
