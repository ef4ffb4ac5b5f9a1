// Lane strips: a road's cross-section as strips side by side. Each strip consists of neighbouring lanes of one kind.
//
//     pavement | verge | kerb | parking |  carriageway: driving, bus, cycle lanes …  | kerb | verge | pavement
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The width of a kerb stone.
inline constexpr double kKerb_m = 0.15625;

/// Neighbouring lanes of one kind, or one kerb.
struct LaneStrip {
  map::LandCoverClass surface{};
  std::vector<map::Lane> lanes;    ///< Left to right; none for a kerb.
  double left_m = 0, right_m = 0;  ///< Offsets of its edges from the axis, to the left positive: left_m > right_m.
  bool has_kerb_left = false, has_kerb_right = false;  ///< True if a kerb adjoins the strip on that side.
};

/// Returns the strips of a road from its left outer edge to its right one, without gaps. Between a level and a raised
/// strip there is a kerb, which takes its width from the raised one. Strips narrower than the tolerance are merged into
/// their inner neighbour. O(lanes).
/// @param tolerance_m  >= 0.
std::vector<LaneStrip> lane_strips_of(const Road& road, double tolerance_m);

}  // namespace citykiln::roads
