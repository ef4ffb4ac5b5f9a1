// From heights at the stops of a line to its profile.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// Knots that move the water by no more than this are dropped.
inline constexpr double kKnotTolerance_m = 0.02;

/// The profile of a line: level across; of its stops those that matter, and all that are pinned, at whose places it is
/// level for an eighth of a metre, so that all lines through a node have its height there to the bit.
///
/// Guarantees: falls where the heights do; off them by less than kKnotTolerance_m. One knot where all is level.
/// O(n log n), at worst O(n²).
Profile profile_of(const RiverLine& line, const RiverHeights& heights);

}  // namespace citykiln::ground
