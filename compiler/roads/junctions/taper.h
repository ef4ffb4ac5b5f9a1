// Tapers: if a street continues wider, narrower or displaced, its kerbs run from one width to the other.
//
//    ---------.                 The wider arm keeps its kerb up to the node; the narrower one widens towards it by
//    - - - - - `-- - - - -      1 m in 5 m. So neither strip sticks out beside the taper.
//               `---------
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/fillet.h"

namespace citykiln::roads {

/// True for two streets that meet at a node and turn by less than 30 degrees there. Paths and stairs change their width
/// abruptly instead.
/// @param lines  Lines of the arms (roads leaving the node).
bool is_taper(Family family, std::span<const ArmLine> lines);

/// Returns the length along which an arm tapers towards the other: at least 1 m.
double taper_length_m(const ArmPath& arm, const ArmPath& other);

/// Returns the area from cut to cut along both arms as a counter-clockwise ring, snapped; nothing if an axis bends too
/// sharply or a cut is 0. The ring may cross itself, which the caller must check. O(n).
/// @param cut_m, other_cut_m  Distances from the node, along each arm, at which the junction ends.
std::optional<Ring> taper_ring(const ArmPath& arm, double cut_m, const ArmPath& other, double other_cut_m);

}  // namespace citykiln::roads
