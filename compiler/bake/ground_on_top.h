// The height of the ground on which parked cars and people stand.
#pragma once

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::bake {

/// Returns the height of the topmost land cover at p, else of the land, in metres. p must lie in both boxes.
double ground_on_top_m(const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded, Vec2 p);

}  // namespace citykiln::bake
