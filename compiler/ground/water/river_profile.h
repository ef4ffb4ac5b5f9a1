// Makes the height profile of a watercourse from the heights of its stations. A station is a place along the
// watercourse at which a height was fitted; it is pinned at ends, junctions and shores, where the profile must have a
// knot. A knot is a point of the profile, which is linear between knots.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// The largest change of the water's height that omitting stations may cause.
inline constexpr double kKnotTolerance_m = 0.02;

/// Returns the profile of a line of the river network. Its knots have no tilt across the watercourse.
///
/// Each station becomes two knots, at the multiples of 1/8 m before and after it, both with the height of its node
/// rounded down to kProfileQuantum_m. So all lines that share a node have exactly its height there. Knots of pinned
/// stations stay; others are omitted by Douglas and Peucker (1973).
///
/// @param line     A line with at least one station.
/// @param heights  Heights by node.
///
/// Guarantees: if the heights descend, so does the profile; it differs from them by less than
/// kKnotTolerance_m + kProfileQuantum_m; a level line has one knot. O(n log n) as a rule, O(n²) at worst.
Profile profile_of(const RiverLine& line, const RiverHeights& heights);

}  // namespace citykiln::ground
