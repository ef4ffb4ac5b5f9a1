// Profiles of watercourses from the heights of their stations.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// Knots that move the water by no more than this are dropped.
inline constexpr double kKnotTolerance_m = 0.02;

/// Returns the profile of a line, without tilt. Pinned stations are kept, level for 1/8 m, so that all lines through a
/// node have its height bit for bit; others by Douglas and Peucker (1973).
///
/// Guarantees: descends where the heights do; differs from them by less than kKnotTolerance_m. One knot where all is
/// level. O(n log n) as a rule, O(n²) at worst.
Profile profile_of(const RiverLine& line, const RiverHeights& heights);

}  // namespace citykiln::ground
