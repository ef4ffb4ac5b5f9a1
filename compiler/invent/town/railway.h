// A railway through the town, with a station.
//
//     ══════╤═══ road      single track on the axis; a siding and platforms at the station
//    ───────┼─────────     a road crosses on the level, or on a bridge if there is room for one
//      ▒▒▒▒▒▒▒▒ platform
//        ▟████▙ station, its square, and a street to the town
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/streets/street_edges.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Half the land of a track, from its axis.
inline constexpr double kTrackHalf_m = 7;

/// Puts a railway past the main centre of a town or city into its plan: the cheapest path over slopes, straight at the
/// station. A village has none, and a world too small for a station neither.
void plan_railway(TownPlan& plan);

/// Returns the places where roads cross the railway on the level. Roads without room for a bridge are split there,
/// others get a bridge.
std::vector<Vec2> cross_railway(const TownPlan& plan, StreetGraph& graph);

/// Joins the square in front of the station to the nearest street that can be reached.
void join_station(const TownPlan& plan, StreetGraph& graph);

/// Adds tracks, crossings, platforms, the station and what stands there.
void add_railway(const TownPlan& plan, const std::vector<Vec2>& level_crossings, InventedMap& map);

}  // namespace citykiln::invent
