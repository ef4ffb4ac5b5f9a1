// Places of moving cars: points of lanes, with the direction of their traffic.
//
//     ─────────────────────────────────────────   kerb, beside which cars may be parked
//        [car] ◄           [car] ◄                a slot every 13 m, of which the traffic takes a share
//     - - - - - - - - - - - - - - - - - - - - -
//            ► [car]             ► [car] [car] |  a queue before the stop line of signals
//     ─────────────────────────────────────────
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/cars/place.h"
#include "compiler/cars/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::cars {

/// The length of a slot of a lane, and the distance from one car of a queue to the next.
inline constexpr double kSlot_m = 13, kQueue_m = 7;

/// The bodies that a place of a lane asks for.
enum class LaneUser : std::uint8_t { kCar, kBus, kLorry };

/// A place of a car in a lane: it lies along the lane, and is as long and wide as the car may be.
struct LanePlace {
  Place place;
  LaneUser user{};
};

/// The settings of traffic.
struct TrafficSettings {
  CarShare share;  ///< The share of slots with a car, or that of traffic.inc.
  buildings::WeekTime time;
  std::uint64_t seed = 0;
};

/// Returns the traffic at a time, as a share of that in the busiest hour: 0 to 1, continuous, with a period of a week.
double traffic_share(buildings::WeekTime time);

/// Returns the taken places in the lanes of a road whose middles lie in a box; other objects are not tested. Each
/// driving lane has cars in the middle of the width that parked cars leave; bus lanes have half the share. Lanes of
/// both directions are driven on the country's side or, where too narrow for two, in one direction drawn by its id.
/// None is on a roundabout or a road without a row in traffic.inc, in a bend of more than some 10 degrees, in a
/// junction, on a painted crossing, or within 8 m of a level crossing. The last 30 m before signals have a queue of up
/// to 4 cars instead, behind the stop line.
///
/// Slots are numbered from the start of the whole way, so the parts of a trimmed way have the places of the whole.
/// O(length + points).
/// @param intervals, stretches  roads::junction_intervals_of() the road, and roads::stretches_of() it.
std::vector<LanePlace> lane_places(const roads::Road& road, std::span<const roads::JunctionInterval> intervals,
                                   std::span<const roads::RoadStretch> stretches, const TrafficSettings& settings,
                                   const Box2& box);

}  // namespace citykiln::cars
