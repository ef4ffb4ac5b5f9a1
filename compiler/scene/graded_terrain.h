// How a chunk's ground is carved, from its recipes.
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The graded terrain of the chunk's tile and a little around it. It has kerbs with Detail::kRoadSurfaces.
/// O(n log n).
ground::GradedTerrain graded_terrain_of(const Header& header, const Chunk& chunk, double tolerance_m);

}  // namespace citykiln::scene
