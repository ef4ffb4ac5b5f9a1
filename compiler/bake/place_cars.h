// Places the parked cars of a tile on the ground. They are no recipes: cars/parked_cars.h draws them from those of
// roads, car parks and yards.
#pragma once

#include <vector>

#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Cars are shown below this tolerance: none is higher.
inline constexpr double kShowsCars_m = 2.25;

/// Returns the cars of a tile by the header's wish, each on the plane through the ground below its wheels,
/// except where that is steeper than 25 % along the car or 12.5 % across it.
/// @param land_cover  With each road as one surface; of the tile and cars::kCarsHalo_m about it.
/// @param graded      The graded terrain of the same box.
/// @param box         The tile.
std::vector<PlacedThing> place_cars(const scene::Header& header, const scene::Chunk& chunk,
                                    const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                    const Box2& box);

}  // namespace citykiln::bake
