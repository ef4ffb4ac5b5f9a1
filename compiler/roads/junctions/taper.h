// Tapers: where a street continues wider, narrower or displaced, its kerbs run from one width to the other.
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

/// True for two arms of streets less than 30 degrees from straight on. Stairs and paths change width in a step.
bool is_taper(Family family, std::span<const ArmLine> lines);

/// Returns the length along which an arm tapers towards the other: at least 1 m.
double taper_length_m(const ArmPath& arm, const ArmPath& other);

/// Returns the area from cut to cut along both axes as a counter-clockwise ring, snapped. Nothing where an axis bends
/// too sharply or a cut is 0. The ring may cross itself; the caller checks. O(n).
std::optional<Ring> taper_ring(const ArmPath& arm, double cut_m, const ArmPath& other, double other_cut_m);

}  // namespace citykiln::roads
