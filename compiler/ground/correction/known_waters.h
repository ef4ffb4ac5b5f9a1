// Heights of water, which keep roads from correcting the land to below the water or far above it.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/correction/known_line.h"
#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Returns lines of KnownKind::kWater: the segments of axes of streams with a profile, and of all
/// rings of land cover with a level (standing water). Others are skipped. Heights are those of the
/// water in metres. O(points).
std::vector<KnownLine> known_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams);

}  // namespace citykiln::ground
