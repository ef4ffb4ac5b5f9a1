// Places for furniture along pavements.
//
//     houses   [#######]  [########]
//     pavement ─────────────────────    1.2 m free
//               ▪       ▪       ▪       stations, every step_m along the way, and furniture 0.35 m from the inner edge
//     ═════════ inner edge ═════════    of the pavement: the kerb, or a verge or cycle track beside it
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::furniture {

/// The distance of stations along a way, and of what stands there from the inner edge of the pavement, in metres.
inline constexpr double kStationStep_m = 8, kBehindKerb_m = 0.35;
/// The width of pavement that stays free, in metres: two people or a wheelchair can pass (DIN 18040-3).
inline constexpr double kFreeWidth_m = 1.2;

/// A place on a pavement.
struct Station {
  StableId key{};            ///< Decides its draws; equal in all tiles that know the road.
  Vec2 inner_edge;           ///< On the pavement's edge towards the carriageway, plane metres.
  Vec2 outward;              ///< The direction from the inner edge away from the carriageway, length 1.
  Vec2 traffic;              ///< The direction of the traffic at this kerb, length 1.
  double room_m = 0;         ///< The width of the pavement: of one lane of it, the one nearest to the kerb.
  double verge_m = 0;        ///< The width of the verge before the pavement; 0: none.
  StableId side{};           ///< Names the side of the way: equal for all of its stations.
  std::uint32_t number = 0;  ///< 2 k on the left and 2 k + 1 on the right for the k-th station of the way.
};

/// Returns the stations of a street's pavements whose inner edge lies in the box widened by kStationStep_m, in order
/// along the way, left before right. Other roads, and pavements narrower than kFreeWidth_m, have none.
/// Distances are counted from the start of the whole OSM way, so a trimmed part has the same stations, bit for bit.
/// Stations less than 1 m before the end of a part may differ: their direction comes from a shorter piece of axis.
/// O(points + stations * lanes).
/// @param step_m  The distance of stations along the way, > 0; that of furniture is kStationStep_m.
std::vector<Station> stations_along(const roads::Road& road, const Box2& box, double step_m);

}  // namespace citykiln::furniture
