// Places the things of yards on the ground. They have no recipes: furniture/yard_things.h draws them from those of
// yards.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Returns the things of a tile's yards, of the kinds whose rules the header has. One whose base would be more than
/// 0.4 m off the ground anywhere is left out.
/// @param trees       The trees of the tile, whose trunks are kept clear.
/// @param land_cover  Has the areas of yards; of the tile and scene::kHalo_m about it.
/// @param graded      Covers the same box.
/// @param box         The tile.
std::vector<PlacedThing> place_yard_things(const scene::Header& header, const scene::Chunk& chunk,
                                           std::span<const plants::Tree> trees,
                                           const ground::LandCoverIndex& land_cover,
                                           const ground::GradedTerrain& graded, const Box2& box);

}  // namespace citykiln::bake
