// Tunnels: the inside of a bore and the frames of its portals.
//
//         ___________
//      __|___________|__   frame, in front of the portal
//     |  |  ceiling  |  |
//     |  |           |  |  lining, seen from inside
//     |__|___road____|__|
#pragma once

#include "compiler/map/heightfield.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// Returns whether a tunnel lies under the terrain: its ceiling does so for at least kMinCoveredShare of its length
/// outside of kPortal_m from its portals, or at its middle if it is shorter.
bool is_underground(const Span& tunnel, const map::Heightfield& heights);

inline constexpr double kPortal_m = 16, kMinCoveredShare = 0.6;

/// Generates a tunnel at a tolerance, > 0: road, walls and ceiling, seen from inside; open at portals and joints,
/// closed at free ends. Frames around portals are closed. Nothing for tunnels that are not is_bored. Total.
GeneratedStructure generate_tunnel(const Span& tunnel, double tolerance_m);

}  // namespace citykiln::structures
