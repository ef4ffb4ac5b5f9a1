// Places what is drawn when a tile is baked: parked cars and street furniture. They have no recipes: cars/parked_cars.h
// and furniture/street_furniture.h draw them from those of streets, car parks and yards.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Cars are shown at tolerances below their greatest height, furniture at tolerances below that of a bench, in metres.
inline constexpr double kShowsCars_m = 2.25, kShowsFurniture_m = 1;

/// The kinds of things that are to be placed.
struct WantedThings {
  bool cars = false, furniture = false;
};

/// The ground of a tile, and lamps and trees on it.
struct TileGround {
  const ground::LandCoverIndex&
      land_cover;                       ///< With each road as one surface; of the tile and scene::kHalo_m about it.
  const ground::GradedTerrain& graded;  ///< Covers the same box.
  const Lamps& lamps;
  std::span<const Vec2> trunks;  ///< plants::GeneratedPlants::trunks.
};

/// Returns the cars of a tile by the header's settings, then its furniture.
///
/// - A car stands on the plane that fits best to the heights of the ground below its four wheels. There is none where
///   that is steeper than 25 % along the car or 12.5 % across it.
/// - Furniture stands upright, as high as the lowest corner of its base; of the kinds whose rules the header has. There
///   is none without scene::Header::has_street_furniture.
///
/// @param box  The tile.
std::vector<PlacedThing> place_generated(const scene::Header& header, const scene::Chunk& chunk,
                                         const TileGround& ground, const Box2& box, const WantedThings& wanted);

}  // namespace citykiln::bake
