// Decides what is set into streets: refuges at crossings with an island, bollards and planters of streets for walkers.
//
//       pedestrian street            crossing with an island
//      |   ▪         ▪   |           ─────────────────────
//      |                 |               ▪    ||||    ▪        refuges between the directions, before and behind it
//      | o   o   o   o   |  bollards ─────────────────────
//     ─┘                 └─
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roadside/clear_zones.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::furniture {

/// The largest distance between bollards across the mouth of a street, in metres; cars cannot pass between them.
inline constexpr double kBollardStep_m = 1.6;
/// Carriageways narrower than this have no room for a refuge, in metres.
inline constexpr double kRefugeRoad_m = 6.5;

/// Returns the refuges of a tile, on streets with two directions of at least kRefugeRoad_m: one before and one behind
/// each crossing that is mapped with an island (crossing:island=yes), and one where traffic_calming=island is mapped.
/// Refuges that would reach into a junction are left out. None depends on assumptions.
std::vector<things::Thing> refuges(const roadside::TileRecipes& recipes, const Box2& box);

/// Returns bollards at the mouths of streets for walkers that meet a street for cars, in countries where that is usual,
/// at 70 % of the mouths and at none within 20 m of a mapped bollard or gate; and planters along streets for walkers
/// at least 7 m wide in all countries, at 60 % of places 16 m apart. A thing is in the tile that contains its
/// middle, on paving, and overlaps none of `standing`. O(length + mouths · mapped things).
/// @param standing  The plans of furniture that stands already.
std::vector<things::Thing> things_of_walked_streets(const roadside::TileRecipes& recipes,
                                                    const roadside::ClearZones& zones, const RectIndex& standing,
                                                    std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
