// Chooses the street lamps of tiles that are written as lights.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/scene/scene.h"

namespace citykiln::outputs {

/// Returns the brightest lamps of each chunk, at most `most` of each, in the plane or inside of
/// the scene's cylinder; with 0 none, at no cost. Cost: grading the
/// terrain of every tile with lamps, in parallel.
std::vector<std::vector<bake::PlacedLamp>> lights_of_tiles(const scene::Scene& scene, std::size_t most, int threads);

}  // namespace citykiln::outputs
