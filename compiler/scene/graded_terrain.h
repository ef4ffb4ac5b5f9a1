// Computes the graded terrain of a chunk (the recipes of one tile) from its recipes. The graded terrain is the terrain
// after roads and water have cut into it.
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// Returns the graded terrain of the chunk's tile and ground::kGrading_m around it, with kerbs where the tolerance has
/// Detail::kRoadSurfaces. O(n log n).
ground::GradedTerrain graded_terrain_of(const Header& header, const Chunk& chunk, double tolerance_m);

}  // namespace citykiln::scene
