// Strips of lanes: a road cut along its length, from the left edge to the right one, into runs of neighbouring lanes of
// one kind of surface.
//
//     pavement | verge | kerb | parking |  carriageway: driving, bus, cycle lanes …  | kerb | verge | pavement
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// How wide a kerb's stone is.
inline constexpr double kKerb_m = 0.15625;

struct LaneStrip {
  map::LandCoverClass surface{};
  std::vector<map::Lane> lanes;    ///< Left to right; none of a kerb.
  double left_m = 0, right_m = 0;  ///< Its edges from the axis, to the left positive: left_m > right_m.
  bool has_kerb_left = false, has_kerb_right = false;
};

/// Left to right, without gaps: from the left edge of what is raised to the right one. Where something is raised, a
/// kerb of its width stands before it. Strips narrower than the tolerance are part of their inner neighbour. O(lanes).
std::vector<LaneStrip> strips_of(const Road& road, double tolerance_m);

}  // namespace citykiln::roads
