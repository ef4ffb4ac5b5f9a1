// Where a street goes on, but wider, narrower or moved to a side: its kerbs run over from the one to the other.
//
//    ---------.                 The wider arm keeps its kerb up to the place; the narrower one widens towards it by
//    - - - - - `-- - - - -      1 m in 5 m. So nothing of either strip sticks out beside the taper.
//               `---------
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/fillet.h"

namespace citykiln::roads {

/// Two arms that a driver takes for one road: of streets, less than some 30 degrees from straight on. Stairs and paths
/// step from one width to another.
bool is_taper(Family family, std::span<const ArmLine> lines);

/// How long an arm tapers towards another one: at least 1 m.
double taper_length_m(const ArmPath& arm, const ArmPath& other);

/// From cut to cut along both axes: a counter-clockwise ring, snapped; nothing where an axis bends too sharply. Whether
/// it is simple is for the caller to see. O(n).
std::optional<Ring> taper_ring(const ArmPath& arm, double cut_m, const ArmPath& other, double other_cut_m);

}  // namespace citykiln::roads
