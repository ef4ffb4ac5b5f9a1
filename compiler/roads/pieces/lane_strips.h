// Lane strips: the strips side by side that make a road's cross-section. Each holds neighbouring lanes of one kind.
//
//     pavement | verge | kerb | parking |  carriageway: driving, bus, cycle lanes …  | kerb | verge | pavement
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The width of a kerb stone.
inline constexpr double kKerb_m = 0.15625;

struct LaneStrip {
  map::LandCoverClass surface{};
  std::vector<map::Lane> lanes;    ///< Left to right; none for a kerb.
  double left_m = 0, right_m = 0;  ///< Offsets of its edges from the axis, to the left positive: left_m > right_m.
  bool has_kerb_left = false, has_kerb_right = false;
};

/// Returns the strips of a road left to right without gaps, from the left outer edge to the right one. A kerb stands on
/// the raised side of each step and takes its width from it. Strips narrower than the tolerance are merged into their
/// inner neighbour. @param tolerance_m  >= 0. O(lanes).
std::vector<LaneStrip> strips_of(const Road& road, double tolerance_m);

}  // namespace citykiln::roads
