// Makes profiles of watercourses from the heights of their stations.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// The largest change of the water's height that dropping knots may cause.
inline constexpr double kKnotTolerance_m = 0.02;

/// Returns the profile of a line, without tilt. It keeps pinned stations, and is level there for 1/8 m, so that all
/// lines through a node have its height bit for bit. It drops other stations by Douglas and Peucker (1973).
///
/// Guarantees: if the heights descend, so does the profile; it differs from them by less than kKnotTolerance_m; a level
/// line has one knot. O(n log n) as a rule, O(n²) at worst.
Profile profile_of(const RiverLine& line, const RiverHeights& heights);

}  // namespace citykiln::ground
