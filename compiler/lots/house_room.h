// Finds the rectangle of a lot on which a house may stand.
//
//      rear             lo          hi
//     ┌─────────────────────────────────┐
//     │            ┌───────────┐        │     at every depth, the rectangle lies in the part of the lot
//     │ beside_m ◄─┤ rectangle ├─► …    │     that contains x = 0, beside_m away from its border
//     │            └───────────┘        │
//    ═╧══════════════ setback_m ════════╧═ street
#pragma once

#include <optional>

#include "compiler/geometry/polygon.h"
#include "compiler/lots/plan_lots.h"

namespace citykiln::lots {

/// The sizes of the room for a house, in metres.
struct RoomSizes {
  double setback_m = 0;  ///< From the pavement to the house.
  double beside_m = 0;   ///< From the house to the lot's sides.
  double most_width_m = 0, most_depth_m = 0;
};

/// The shortest side of a house, and its least distance to the rear of the lot, measured on the line x = 0.
inline constexpr double kLeastHouse_m = 5, kLeastRear_m = 3;

/// Returns the largest of the rectangles that begin at setback_m and grow by steps of 0.5 m of depth, each in the
/// middle of the width that is free at all its depths, in the frame of the lot; nothing if a side would be shorter than
/// kLeastHouse_m. It lies in the lot. O(vertices · depth).
std::optional<Box2> room_for_house(const Polygon& lot, const Frame& frame, const RoomSizes& sizes);

/// Returns a rectangle of the frame in the plane: counter-clockwise, the first edge along the street, snapped.
Polygon plane_rectangle(const Frame& frame, const Box2& box);

}  // namespace citykiln::lots
