// Decides where poles with wires stand along streets, where no map shows power lines.
//
//     houses    [#######]  [########]
//            o───────────o───────────o    every 32 m along the way, on one side
//     ═════════ kerb ═══════════════
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roadside/clear_zones.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// The distance of poles along a way, in metres.
inline constexpr double kPoleStep_m = 32;
/// Wires hang between neighbouring poles that are at most this far apart, in metres.
inline constexpr double kLongestPoleSpan_m = 70;
/// Pavements at least this wide are those of centres, which have their lines in the ground, in metres.
inline constexpr double kCentrePavement_m = 3;

/// Wires between two poles.
struct PoleSpan {
  ObjectId id;             ///< The id of the street, with a part for each span.
  std::uint32_t from, to;  ///< Indices into UtilityPoles::poles.
};

/// The poles of a tile and its surroundings.
struct UtilityPoles {
  std::vector<things::Thing> poles;
  std::vector<PoleSpan> spans;  ///< The spans whose middle lies in the tile.
};

/// Returns the poles whose foot lies in a box widened by kLongestPoleSpan_m / 2, and the spans of the box. Each whole
/// way has poles or not, on its left or right, by the shares of things/utility_poles.inc for its country and class. A
/// pole
///
/// - stands 0.4 m behind the kerb, or 0.25 m inside the edge of a carriageway without kerbs;
/// - is outside of the zones of streets (roadside/clear_zones.h), off walls and water;
/// - carries its wires along the street.
///
/// Two tiles that know a place agree on its poles, since things, lamps and doors do not count. O(roads · length).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile.
UtilityPoles utility_poles(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones, std::uint64_t seed,
                           const Box2& box);

}  // namespace citykiln::furniture
