// Places for furniture along pavements.
//
//     houses   [#######]  [########]
//     pavement ─────────────────────    1.2 m free
//               ▪       ▪       ▪       stations, every 8 m along the way, 0.35 m from the inner edge
//     ═════════ inner edge ═════════    of the pavement: the kerb, or a verge or cycle track beside it
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::furniture {

/// The distance of stations along a way, and of what stands there from the inner edge of the pavement, in metres.
inline constexpr double kStationStep_m = 8, kBehindKerb_m = 0.35;
/// The width of a pavement that stays free, in metres: two people pass, or a wheelchair (DIN 18040-3).
inline constexpr double kFreeWidth_m = 1.2;

/// A place on a pavement.
struct Station {
  StableId key{};            ///< Decides its draws; equal in all tiles that know the road.
  Vec2 inner_edge;           ///< On the pavement's edge towards the carriageway, plane metres.
  Vec2 outward;              ///< From there to the houses, length 1.
  Vec2 traffic;              ///< The direction of the traffic at this kerb, length 1.
  double room_m = 0;         ///< The width of the pavement: of one lane of it, the one nearest to the kerb.
  double verge_m = 0;        ///< The width of the verge before the pavement; 0: none.
  StableId side{};           ///< Names the side of the way: equal for all of its stations.
  std::uint32_t number = 0;  ///< Counts the stations of a way, those on the left evenly.
};

/// Returns the stations of a road's pavements whose inner edge lies in a box widened by 8 m, in order along the way.
/// They are numbered from the start of the whole way, so the parts of a trimmed way have the stations of the whole:
/// equal bit for bit, except less than 1 m before a part's end, where the direction of the axis is measured on less.
/// Pavements of less than kFreeWidth_m have none. O(points + stations · lanes).
/// @param step_m  The distance of stations along the way, > 0; that of furniture is kStationStep_m.
std::vector<Station> stations_along(const roads::Road& road, const Box2& box, double step_m);

}  // namespace citykiln::furniture
