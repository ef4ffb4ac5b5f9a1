// Draws the street furniture of a tile: benches, bins, signs and the like on pavements where none is mapped near.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::furniture {

/// A piece is left out this near to a mapped one of its kind, in metres.
inline constexpr double kNoneNearMapped_m = 40;
/// A pavement is beside shops, or beside houses, within this distance of a front or of a building, in metres.
inline constexpr double kBesideFront_m = 14, kBesideHouse_m = 16;
/// The least distance of two stations with furniture: no two of the largest pieces meet, 3.2 by 0.8 m.
inline constexpr double kStationsApart_m = 3.5;

/// Returns the furniture of a tile: for each station of its pavements one piece or none, drawn by the rates of
/// street_kinds.inc, before pieces are left out. It faces the street, or the traffic at its kerb, as its row says. A
/// piece
///
/// - lies wholly on pavement, with kFreeWidth_m behind it; of signs, whose plates are overhead, behind the pole;
/// - is outside of the zones of streets, doors, trunks, things and lamps (roadside/clear_zones.h);
/// - overlaps no other one: of stations nearer than kStationsApart_m, such as those of two ways at a corner, only the
/// one
///   with the lowest key counts, in all tiles alike.
///
/// A piece is in the tile that contains its middle. Things, doors and lamps of the next tile do not count. O(stations).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile.
std::vector<things::Thing> street_furniture(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                            std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
