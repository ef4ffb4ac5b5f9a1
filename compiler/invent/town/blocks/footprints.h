// Footprints of houses on a lot.
#pragma once

#include <optional>

#include "compiler/invent/town/blocks/town_lots.h"

namespace citykiln::invent {

/// A rectangle on a lot, seen from its street.
struct HouseBox {
  double width_m = 10, depth_m = 9;
  double setback_m = 4;  ///< From the frontage.
  double aside_m = 0;    ///< From the middle of the frontage, along it.
};

/// Returns the rectangle of a box on a lot, counter-clockwise, its first edge towards the street.
Ring box_ring(const TownLot& lot, const HouseBox& box);

/// Returns the largest of a box and smaller ones that lies within the lot and `margin_m` from its borders; nothing if
/// the lot has no room for one of half its width.
std::optional<Ring> fitted_box(const TownLot& lot, HouseBox box, double margin_m);

/// Returns the footprint of a house that reaches from one side border to the other, such as those of closed rows: the
/// land between two distances from the lot's streets. On a corner it has two wings. Empty if it would be too small.
Ring row_ring(const TownLot& lot, double setback_m, double depth_m);

/// True if a ring lies within another, its corners at least margin_m from the border.
bool lies_within(const Ring& ring, const Ring& outer, double margin_m);

}  // namespace citykiln::invent
