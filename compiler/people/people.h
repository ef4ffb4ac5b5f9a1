// The people of a tile, who do not move: they stand, walk or sit at a share of its spots.
//
// A spot is in the tile that contains its middle, with all of its people. A spot of a street or square is left out if
// it
//   - is not on ground for walkers: pavements, squares, platforms, foot paths, pedestrian streets;
//   - overlaps a spot with a lower key, even if that one is left out itself, or a spot of a stop or bench.
// A person is left out who would stand off that ground, in a thing, a lamp, a trunk or a barrier. Spots at stops and on
// benches are known in the tile of the thing alone, and give way to others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/people/body.h"
#include "compiler/people/presence.h"
#include "compiler/people/spots.h"
#include "compiler/props/recipe.h"

namespace citykiln::people {

/// The recipes of a tile and of what lies about it.
struct StreetLife {
  std::span<const roads::Road> roads;
  std::span<const roads::Junction> junctions;
  std::span<const buildings::Building> buildings;
  std::span<const Vec2> trunks;
  std::span<const props::Barrier> barriers;
  std::span<const Solid> solids;             ///< Things and lamps of the tile, drawn furniture included.
  const ground::LandCoverIndex& land_cover;  ///< With each road as one surface; of the tile and kPeopleHalo_m about it.
};

/// How far beyond a tile its people depend on land cover.
inline constexpr double kPeopleHalo_m = 24;
/// A spot is before shops, or beside houses, within this distance of a front or of a building, in metres.
inline constexpr double kBeforeShops_m = 9, kBesideHouses_m = 16;
/// The room of a person: half of the width of the shoulders, in metres.
inline constexpr double kPersonRadius_m = 0.28;

/// The values that decide where people are.
struct PeopleWish {
  PeopleShare share;
  buildings::WeekTime time;
  Season season{};
  map::CountryGroup country{};  ///< The country of the scene: of looks, and of spots of squares, stops and benches.
  std::uint64_t seed = 0;
  double tile_m = 0;  ///< Side of the tiles.
};

/// Returns the spots of a tile with their uses: those of stops and benches, then the others, each sorted by key.
///
/// Guarantees: disjoint boxes share no spots. Two spots of streets, crossings and squares do not overlap. Spots of
/// stops and benches may overlap each other, and spots of other tiles. O(spots + roads).
/// @param box  The tile; lower sides inclusive, upper sides exclusive.
std::vector<Spot> spots_in(const StreetLife& life, const PeopleWish& wish, const Box2& box);

/// Returns the people of a tile as things of form_of(), in the order of their spots. The result depends only on the
/// arguments. Ids are unique in a tile only.
std::vector<things::Thing> people_in(const StreetLife& life, const PeopleWish& wish, const Box2& box);

}  // namespace citykiln::people
