// Places the street furniture of a tile on the ground. It has no recipes: furniture/street_furniture.h draws it from
// those of roads and buildings.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/furniture/street_furniture.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Furniture is shown below this tolerance, in metres: it is about as low as a bench.
inline constexpr double kShowsFurniture_m = 1;

/// Returns the recipes of a chunk from which furniture is drawn.
furniture::StreetRecipes street_recipes_of(const scene::Chunk& chunk, std::span<const plants::Tree> trees,
                                           std::span<const props::StreetLamp> lamps,
                                           const ground::LandCoverIndex& land_cover);

/// Returns the trees of a tile's recipes and those that are assumed along its streets (furniture/street_trees.h), which
/// there are none of without scene::Header::has_street_furniture.
std::vector<plants::Tree> trees_with_street_trees(const scene::Header& header, const scene::Chunk& chunk,
                                                  const Lamps& lamps, const ground::LandCoverIndex& land_cover,
                                                  const Box2& box);

/// Returns the furniture of a tile, of the kinds whose rules the header has; none without
/// scene::Header::has_street_furniture.
/// @param trees       trees_with_street_trees(); furniture keeps off their trunks.
/// @param land_cover  With each road as one surface; of the tile and scene::kHalo_m about it.
/// @param graded      Covers the same box.
/// @param box         The tile.
std::vector<PlacedThing> place_furniture(const scene::Header& header, const scene::Chunk& chunk,
                                         std::span<const plants::Tree> trees, const Lamps& lamps,
                                         const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                         const Box2& box);

}  // namespace citykiln::bake
