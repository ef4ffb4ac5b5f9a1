// Decides what stands before shop fronts: tables of cafés, displays of shops, boards.
//
//     front      [  window  | door |  window  ]
//                 ▪▪▪ ▪▪▪              ▪▪▪      0.15 m from the wall, clear of doors
//                ──────────────────────────    1.5 m stay free
//     ═══════════════ kerb ═══════════════
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/oriented_rect.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::furniture {

/// The width that stays free to walk before things at fronts, in metres.
inline constexpr double kWalkBeforeFront_m = 1.5;

/// Returns the things before the shop fronts of a tile's buildings, by the shares of things/front_kinds.inc. A thing
///
/// - lies on paving, with kWalkBeforeFront_m of paving before it;
/// - is outside of the zones of streets, doors, trunks, things and lamps (roadside/clear_zones.h), and 1.05 m from the
///   door that is drawn: in the middle of fronts longer than 5 m, else at both ends;
/// - overlaps none of `standing`.
///
/// A front has at most six things, of one kind, and at most one board. Things whose middle lies outside of the tile are
/// left out. O(fronts · things made).
/// @param zones     clear_zones_of() the recipes.
/// @param standing  The plan rectangles of furniture that was placed before.
/// @param box       The tile.
std::vector<things::Thing> front_things(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                        const RectIndex& standing, std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
