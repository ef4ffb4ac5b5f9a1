// Finds approach paths: paths that lead up to a bridge or down to a tunnel (steps, ramps, pavements), or pass below a
// bridge. Paths follow the ground, but these may be raised or lowered where a clearance needs it. Steps up to the
// middle of a bridge are not: the ground below would become a hill.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::ground {

/// A path is an approach if it begins within this distance, along paths, of the end of a bridge or tunnel: a storey of
/// 5.5 m at 3/8, twice.
inline constexpr double kApproach_m = 32;
/// Longer paths lead elsewhere and stay on the ground.
inline constexpr double kLongestApproach_m = 2048;

/// Returns per track whether it is an approach: on the ground, of a class without profiles, connected by map nodes to
/// the end of a bridge or tunnel (where no other continues) or crossed by a bridge; never connected to where one
/// continues. Does not depend on the order of tracks. Depends on tracks within both constants above. O(n log n) in
/// vertices.
std::vector<bool> approach_paths(const map::Features& features);

}  // namespace citykiln::ground
