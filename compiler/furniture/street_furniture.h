// Draws the street furniture of a tile: benches, bins, signs and the like on pavements where none is mapped near.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::furniture {

/// A piece is left out within this distance of a thing of its kind in the recipes of the tile, in metres.
inline constexpr double kNoneNearMapped_m = 40;
/// A pavement is beside shops, or beside houses, within this distance of a front or of a building, in metres.
inline constexpr double kBesideFront_m = 14, kBesideHouse_m = 16;
/// The least distance of two stations with furniture: no two of the largest pieces meet, 3.2 by 0.8 m.
inline constexpr double kStationsApart_m = 3.5;

/// Returns the street furniture of a tile: at most one piece for each station of its pavements, by the rates of
/// street_kinds.inc. Rates count pieces before the tests below. Signs face the traffic at their kerb, all other kinds
/// face the street. A piece
///
/// - has its middle and its four corners on pavement;
/// - leaves kFreeWidth_m of pavement free behind it, or behind the pole of a sign, whose plates are overhead;
/// - is outside of the zones of streets, doors, trunks, things and lamps (roadside/clear_zones.h);
/// - belongs to a station that has no station with a lower key within kStationsApart_m, even if that one has no piece.
///   So all tiles choose the same stations.
///
/// A piece is in the tile that contains its middle. Things, doors and lamps of other tiles do not count.
/// Ids are unique in a tile only. O(stations * things).
/// @param zones  The result of clear_zones_of(recipes).
/// @param seed   The seed of the scene.
/// @param box    The tile; lower sides inclusive, upper sides exclusive.
std::vector<things::Thing> street_furniture(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                            std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
