// The height of the ground on which things stand that are drawn when a tile is baked.
#pragma once

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::bake {

/// Returns the height of the topmost surface at a place: on pavements that of the pavement. Both must cover it.
double ground_on_top_m(const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded, Vec2 p);

}  // namespace citykiln::bake
