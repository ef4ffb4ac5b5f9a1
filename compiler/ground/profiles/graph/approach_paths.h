// Finds approach paths: paths that lead up to a bridge or down to a tunnel (steps, ramps, pavements), or pass below a
// bridge. Other paths follow the ground, but approach paths may be raised or lowered for a clearance. Steps up to the
// middle of a bridge are no approach paths, as the ground below them would become a hill.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::ground {

/// A path is an approach if it begins within this distance, along paths, of the end of a bridge or tunnel: twice the
/// length in which a ramp of grade 3/8 climbs a storey of 5.5 m.
inline constexpr double kApproach_m = 32;
/// Longer paths lead elsewhere and stay on the ground.
inline constexpr double kLongestApproach_m = 2048;

/// Returns for each track true if it is an approach path: it is on the ground, its class has no profiles, and it is
/// crossed by a bridge or connected by map nodes to the end of a bridge or tunnel that no other bridge or tunnel
/// continues. The order of tracks does not matter. Depends on tracks within kApproach_m and kLongestApproach_m. O(n log
/// n) in vertices.
std::vector<bool> approach_paths(const map::FeatureView& features);

}  // namespace citykiln::ground
