// Stage 6: which buildings stand, how deep and how high.
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// Footprints become buildings, sorted by id. Heights count from the lowest ground along the footprint's walls, parts
/// from that of their outline where one contains them; a building that would not rise at least kLeastRise_m above its
/// highest ground is raised (kHeightRaised). Walls reach kFoundation_m below the lowest ground. Outlines replaced by
/// their parts count as merged. Ledger "buildings/footprint". Total.
std::vector<Building> plan(const map::Features& features, const ground::GradedTerrain& ground, Report& report);

}  // namespace citykiln::buildings
