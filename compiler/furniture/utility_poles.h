// Decides where utility poles with wires stand along streets. Mapped power lines are not looked at.
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

/// The distance between poles along a way, in metres; an estimate.
inline constexpr double kPoleStep_m = 32;
/// Wires hang between consecutive poles up to this distance, in metres: one missing pole is bridged, two are not.
inline constexpr double kLongestPoleSpan_m = 70;
/// Pavements at least this wide are those of centres, which have their lines in the ground, in metres.
inline constexpr double kCentrePavement_m = 3;

/// Wires between two poles.
struct PoleSpan {
  ObjectId id;             ///< The id of its second pole.
  std::uint32_t from, to;  ///< Indices into UtilityPoles::poles.
};

/// The poles of a tile and its surroundings.
struct UtilityPoles {
  std::vector<things::Thing> poles;
  std::vector<PoleSpan> spans;  ///< The spans whose middle lies in the tile.
};

/// Returns the poles whose foot lies in the box widened by kLongestPoleSpan_m / 2, and the spans whose middle lies in
/// the box. Each OSM way has poles or none, all on one side, by the percentages of things/utility_poles.inc. Main
/// streets are secondary and tertiary; other streets are residential; further classes have none. A pole
///
/// - stands 0.4 m behind the kerb, or 0.25 m inside the edge of a carriageway without kerbs;
/// - is outside of the clear zones of streets, 0.4 m or more from walls, and not in water;
/// - carries its wires along the street.
///
/// Neighbouring tiles make the same poles: things, lamps, doors and trunks do not count. O(poles + roads).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile.
UtilityPoles utility_poles(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones, std::uint64_t seed,
                           const Box2& box);

}  // namespace citykiln::furniture
