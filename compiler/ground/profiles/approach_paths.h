// Finds approach paths: paths that lead up to a bridge or down to a tunnel (steps, ramps, pavements), or pass below a
// bridge. Other paths follow the ground, but approach paths may be raised or lowered for a clearance. Steps up to the
// middle of a bridge are no approach paths, as the ground below them would become a hill.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::ground {

/// A path is an approach if it begins within this distance, along paths, of the end of a bridge or tunnel: a storey of
/// 5.5 m at 3/8, twice.
inline constexpr double kApproach_m = 32;
/// Longer paths lead elsewhere and stay on the ground.
inline constexpr double kLongestApproach_m = 2048;

/// Returns per track true if it is an approach: it is on the ground, of a class without profiles, and connected by map
/// nodes to the end of a bridge or tunnel that no other bridge or tunnel continues, or crossed by a bridge. A path
/// connected to a node where a bridge or tunnel continues is none. Does not depend on the order of tracks. Depends on
/// tracks within both constants above. O(n log n) in vertices.
std::vector<bool> approach_paths(const map::Features& features);

}  // namespace citykiln::ground
