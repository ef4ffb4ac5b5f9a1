// Places for furniture along pavements.
//
//     houses   [#######]  [########]
//     pavement ─────────────────────    1.2 m free
//               ▪       ▪       ▪       stations, every 8 m along the way, 0.35 m inside the kerb
//     ═════════ kerb ═══════════════
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::furniture {

/// The distance of stations along a way, and of what stands there from the kerb, in metres.
inline constexpr double kStationStep_m = 8, kBehindKerb_m = 0.35;
/// The width of a pavement that stays free, in metres: two people pass, or a wheelchair (DIN 18040-3).
inline constexpr double kFreeWidth_m = 1.2;

/// A place on a pavement.
struct Station {
  StableId key{};     ///< Decides its draws; equal in all tiles that know the road.
  Vec2 kerb;          ///< On the kerb's pavement side, plane metres.
  Vec2 outward;       ///< From the kerb to the houses, length 1.
  double room_m = 0;  ///< The width of the pavement.
};

/// Returns the stations of a road's pavements whose kerb lies in a box widened by 8 m, in order along the way. They are
/// numbered from the start of the whole way, so the parts of a trimmed way have the stations of the whole, bit for bit.
/// Pavements of less than kFreeWidth_m have none. O(points + stations · lanes).
/// @param step_m  Their distance along the way; of furniture kStationStep_m.
std::vector<Station> stations_along(const roads::Road& road, const Box2& box, double step_m);

}  // namespace citykiln::furniture
