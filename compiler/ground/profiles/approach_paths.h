// Paths that lead up to what leaves the ground (steps, ramps, pavements), or pass below it. They follow the ground as
// it is, but where a bridge needs room below it, or an underpass above it, they climb and go down. Steps up to the
// middle of a bridge do not: there would be a hill below it.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::ground {

/// Paths that begin within this of a bridge's or tunnel's end, along paths, lead up to it: a storey, 5.5 m, at three
/// eighths, twice.
inline constexpr double kApproach_m = 32;
/// Longer paths lead elsewhere, and stay on the ground as it is.
inline constexpr double kLongestApproach_m = 1024;

/// By track: on the ground, of a class without heights of its own; joined by nodes of the map to where a bridge
/// or tunnel ends and no other goes on, or crossed by a bridge; never joined to where one goes on. Does not depend on
/// the order of tracks. Reach: both of the above. O(n log n) in vertices.
std::vector<bool> approach_paths(const map::Features& features);

}  // namespace citykiln::ground
