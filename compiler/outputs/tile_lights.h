// Chooses the street lamps of tiles that are written as lights.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/scene/scene.h"

namespace citykiln::outputs {

/// Returns the brightest lamps of a chunk of the header's scene, at most `most`, in the plane or inside of the scene's
/// cylinder; with 0 none, at no cost. Cost: grading the terrain of the tile, if it has lamps.
std::vector<bake::PlacedLamp> lights_of(const scene::Header& header, const scene::Chunk& chunk, std::size_t most);
/// Returns lights_of() each chunk, made in parallel.
std::vector<std::vector<bake::PlacedLamp>> lights_of_tiles(const scene::Scene& scene, std::size_t most, int threads);

}  // namespace citykiln::outputs
