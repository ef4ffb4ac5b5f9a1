// The recipes of a tile from which parked cars and street furniture are drawn. None of these is a recipe itself: they
// are functions of the recipes of streets, yards and car parks, and are made when a tile is baked.
#pragma once

#include <span>

#include "compiler/buildings/recipe.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/lots/recipe.h"
#include "compiler/pitches/recipe.h"
#include "compiler/props/recipe.h"
#include "compiler/props/street_lamps.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"
#include "compiler/things/recipe.h"

namespace citykiln::roadside {

/// How far beyond a tile what is drawn depends on land cover.
inline constexpr double kHalo_m = 40;

/// The recipes of a tile. Roads, junctions, yards, pitches and trunks are also known near it, each as far as a chunk
/// holds it (scene::Chunk), so all tiles near a place know the same. Things, lamps and buildings are those of the tile
/// alone; barriers that are no hedges too.
struct TileRecipes {
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;
  std::span<const lots::Yard> yards;
  std::span<const lots::Yard> plots;  ///< Ground that no lot has (vacant/plots.h), of the tile alone.
  std::span<const pitches::Pitch> pitches;
  std::span<const Vec2> trunks;              ///< The places of single trees and trees of rows.
  std::span<const things::Thing> things;     ///< With mapped parking spaces: things of the role map::ThingRole::kCar.
  std::span<const props::StreetLamp> lamps;  ///< Mapped ones, and those along lit streets.
  std::span<const props::Barrier> barriers;
  std::span<const buildings::Building> buildings;
  const ground::LandCoverIndex& land_cover;  ///< With each road as one surface; of the tile and kHalo_m about it.
  double tile_m = 0;                         ///< Side of the tiles (roads::stretches_of()).
};

}  // namespace citykiln::roadside
