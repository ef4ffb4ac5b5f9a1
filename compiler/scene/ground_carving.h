// How a chunk's ground is carved, from its recipes.
#pragma once

#include "compiler/ground/grading/carving.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The carved ground of the chunk's tile and a little around it. From kPlainRoads_m on no tolerance sees kerbs.
/// O(n log n).
ground::Carving carving_of(const Header& header, const Chunk& chunk, double tolerance_m);

}  // namespace citykiln::scene
