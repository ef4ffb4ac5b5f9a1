// Measures the room beside a stretch of road: the width that a strip beyond the kerb can have before it meets what is
// mapped. The geometry is exact, while beside.h looks at samples.
//
//           strip     ________________________      a mapped line is clipped to the strip beside each straight piece of
//           to kerb  ___/_____________________        the axis, and to the wedge at the outer side of each bend; the
//           axis ___/________________________      room is the least distance from the axis to the clipped line, less
//                                                  half the width of the line and the distance from axis to kerb
#pragma once

#include <limits>

#include "compiler/assume/beside.h"
#include "compiler/map/cross_section.h"

namespace citykiln::assume {

/// If a way meets the stretch at a node, it does not limit the room within this distance of the node: there is a
/// junction.
inline constexpr double kJunctionReach_m = 24;
/// If a wall is nearer to the kerb than this at any place, the room is 0: what roads/width_limits keeps of a pavement,
/// and its rounding to quarter metres. In bends, between corners of the axis less than 8 m apart, it is 2 m.
inline constexpr double kLeastBeforeWalls_m = map::kMinPavement_m + 0.25;
/// kLeastBeforeWalls_m for closed rows of houses: the middle of the pavement that is kept at junctions lies before the
/// wall.
inline constexpr double kLeastBeforeRows_m = 0.375;
/// The widest strip for which the room is measured. A greater room is infinite.
inline constexpr double kWidestStrip_m = 8;

/// The least distances from the left and the right kerb of a stretch to what is mapped on that side, at least 0.
/// Infinity: nothing is near.
struct Room {
  double left_m = std::numeric_limits<double>::infinity(), right_m = std::numeric_limits<double>::infinity();
};

/// Returns the room along the whole stretch. Water, squares, rails, other streets and paths that run along the stretch
/// (kAlong) limit it. Buildings limit it in bends; elsewhere they only make it 0, if they are nearer than
/// kLeastBeforeWalls_m. Barriers and car parks do not limit it, but see SideFacts::room_m. O(lines near it).
Room room_beside(const Surroundings& surroundings, const map::Track& stretch);

/// Returns the room as room_beside(), but before all except ways that may lie on a pavement, and with
/// kLeastBeforeRows_m in place of kLeastBeforeWalls_m.
Room room_over_footways(const Surroundings& surroundings, const map::Track& stretch);

/// True for footways, which a pavement may cover, and for cycle paths, which lie on it.
bool may_lie_on_pavement(const map::Track& way);

/// True for paved footways and other footpaths without a tagged surface: the ways that are mapped for pavements.
bool is_footway(const map::Track& way);

}  // namespace citykiln::assume
