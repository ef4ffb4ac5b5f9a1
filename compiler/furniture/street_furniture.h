// Decides what stands on the pavements of a tile where the map is silent.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/lots/recipe.h"
#include "compiler/plants/recipe.h"
#include "compiler/props/street_lamps.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// A piece is left out this near to a mapped one of its kind, in metres.
inline constexpr double kNoneNearMapped_m = 40;
/// A pavement is beside shops, or beside houses, within this distance of a front or of a building, in metres.
inline constexpr double kBesideFront_m = 14, kBesideHouse_m = 16;
/// The distance from lamps, in metres.
inline constexpr double kFromLamp_m = 0.75;

/// The recipes of a tile and of what lies about it.
struct StreetRecipes {
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;
  std::span<const lots::Yard> yards;
  std::span<const buildings::Building> buildings;
  std::span<const things::Thing> things;
  std::span<const plants::Tree> trees;
  std::span<const plants::TreeRow> tree_rows;
  std::span<const props::StreetLamp> lamps;
  const ground::LandCoverIndex& land_cover;  ///< With each road as one surface.
};

/// Returns the furniture of a tile: for each station of its pavements one piece or none, drawn by the rates of
/// street_kinds.inc. A piece
///
/// - lies wholly on pavement, with kFreeWidth_m behind it;
/// - keeps the distances of parked cars (cars/kept_clear.h) from junctions, crossings, drives, doors, trunks and
/// things.
///
/// A piece is in the tile that contains its middle. Things, doors and lamps of the next tile do not count.
/// @param tile_m  Side of the tiles.
/// @param box     The tile.
std::vector<things::Thing> street_furniture(const StreetRecipes& recipes, std::uint64_t seed, double tile_m,
                                            const Box2& box);

}  // namespace citykiln::furniture
