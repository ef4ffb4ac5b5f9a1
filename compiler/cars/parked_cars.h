// Parked cars of a tile: a share of the parking places that its recipes give, where nothing is in the way.
//
// A place is in the tile that contains its middle. It is left out if it
//   - is not wholly on its ground: its carriageway, its car park, or open ground for others (has_ground());
//   - overlaps a place of an earlier kind, or of its own kind with a lower key;
//   - is on ground that is kept clear (kept_clear.h).
// The first two depend on data that all tiles near it have, so that neighbouring tiles agree.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/cars/kept_clear.h"
#include "compiler/cars/place.h"
#include "compiler/cars/recipe.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/pitches/recipe.h"

namespace citykiln::cars {

/// The recipes of a tile and its surroundings.
struct TileRecipes {
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;
  std::span<const lots::Yard> yards;
  std::span<const pitches::Pitch> pitches;
  std::span<const plants::Tree> trees;
  std::span<const things::Thing> things;  ///< With mapped parking spaces: things of the role map::ThingRole::kCar.
  std::span<const props::Barrier> barriers;
  std::span<const buildings::Building> buildings;
  const ground::LandCoverIndex& land_cover;  ///< With each road as one surface; of the tile and kCarsHalo_m about it.
};

/// How far beyond a tile its places depend on land cover.
inline constexpr double kCarsHalo_m = 40;

/// The values that decide which places have a car.
struct CarWish {
  CarShare share;
  buildings::WeekTime time;
  map::CountryGroup country{};  ///< The country of places that belong to no road or yard.
  std::uint64_t seed = 0;
  double tile_m = 0;  ///< Side of the tiles.
};

/// Returns the places of a tile where a car may stand, sorted by kind and key.
///
/// Guarantees: disjoint boxes share no places; no two places of neighbouring boxes overlap. O(places + roads).
/// @param box  The tile; lower sides inclusive, upper sides exclusive.
std::vector<Place> places_in(const TileRecipes& recipes, const CarWish& wish, const Box2& box);

/// Returns the cars of a tile as things, in the order of their places. A car stands within its place, up to 1 degree
/// askew. Depends on the seed, the hour and the wish; not on threads.
std::vector<things::Thing> parked_cars(const TileRecipes& recipes, const CarWish& wish, const Box2& box);

}  // namespace citykiln::cars
