// Bores: a tunnel as seen from inside, and the frames of its mouths.
//
//         ___________
//      __|___________|__   frame, in front of the mouth
//     |  |  ceiling  |  |
//     |  |           |  |  lining: looks inwards
//     |__|___road____|__|
#pragma once

#include "compiler/map/heightfield.h"
#include "compiler/structures/generate.h"

namespace citykiln::structures {

/// True where a tunnel lies under the land as it is: its ceiling, more than kPortal_m from its mouths, for most of its
/// length; a shorter one in its middle.
bool is_underground(const Span& tunnel, const map::Heightfield& heights);

inline constexpr double kPortal_m = 16, kMinCoveredShare = 0.6;

/// The bore at a tolerance.
///
/// Road, walls and ceiling, seen from inside; open where it comes out on the ground or meets another tunnel, closed
/// where it meets nothing. A frame stands about each mouth on the ground; it is closed. Not bored: nothing. Total.
GeneratedStructure generate_tunnel(const Span& tunnel, double tolerance_m);

}  // namespace citykiln::structures
