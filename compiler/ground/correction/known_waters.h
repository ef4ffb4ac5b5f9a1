// Lines of water, which roads neither uncover nor bury.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/correction/known_line.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Returns the axes of streams with profiles and the shores of standing water with levels, as KnownKind::kWater.
/// O(points).
std::vector<KnownLine> known_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams);

}  // namespace citykiln::ground
