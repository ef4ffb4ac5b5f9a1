// The room beside a stretch of road, measured exactly: how far a strip may reach beyond the kerb before it meets what
// is mapped.
//
//           strip     ________________________      a mapped line is cut to the strip beside each straight piece, and
//           to kerb  ___/_____________________        the wedge at the outer side of each bend; its least distance from
//           axis ___/________________________      the axis there, less its half width and the kerb, is the room
#pragma once

#include <limits>

#include "compiler/assume/beside.h"

namespace citykiln::assume {

/// Ways that share a node with the stretch may come nearer within this distance of it: there is a junction.
inline constexpr double kJunctionReach_m = 24;
/// Buildings that leave less than this between kerb and wall anywhere leave no room: what roads/width_limits keeps of a
/// pavement, with its rounding.
inline constexpr double kLeastBeforeWalls_m = 0.75;
/// No strip reaches farther beyond the kerb.
inline constexpr double kWidestStrip_m = 8;

/// The distances from the kerbs of a stretch to what is mapped beside it.
struct Room {
  double left_m = std::numeric_limits<double>::infinity(), right_m = std::numeric_limits<double>::infinity();
};

/// Returns the room up to water, squares, rails, other streets and the paths that run along the stretch, all along it;
/// 0 where buildings leave less than kLeastBeforeWalls_m anywhere. O(lines near it).
Room room_beside(const Surroundings& surroundings, const map::Track& stretch);

}  // namespace citykiln::assume
