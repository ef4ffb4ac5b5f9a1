// How wide streets are, and the tags of streets.
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/streets/street_edges.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// The widths of a street, which is the same on both sides.
struct StreetSection {
  int lanes = 2;
  double carriageway_m = 5.5;
  double pavement_m = 2;  ///< On each side; 0: none.
  double parking_m = 0;   ///< On each side, for parked cars.
  /// Returns the distance from the axis to the land beside the street, with 0.4 m to spare.
  double half_m() const { return carriageway_m / 2 + parking_m + pavement_m + 0.4; }
};

/// Returns the section of a street in a town.
StreetSection street_section(const TownPlan& plan, const StreetEdge& edge, StreetClass street_class);

/// Returns the tags of an edge: class, name, lanes, surface, speed, pavements, lamps.
Tags street_tags(const TownPlan& plan, const StreetEdge& edge, const Street& street);

}  // namespace citykiln::invent
