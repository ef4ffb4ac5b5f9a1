// The mean height and colour of a wood at a position, as seen from above. The canopy (canopy.h), one surface that
// replaces the trees of a dense wood at coarse levels, takes the heights and colours of its vertices from here.
#pragma once

#include <array>

#include "compiler/plants/placing/wood_index.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// The wood at a position.
struct CrownAverage {
  double height_m = 0;  ///< Mean height of the sampled trees; 0: no wood within 6 m.
  /// Uniform random number in [0, 1) that depends on the position only. It varies the canopy's height.
  double uniform = 0;
  /// Linear reflectance (red, green, blue) of crowns and of the ground that shows between them.
  std::array<double, 3> colour{};
  std::uint32_t wood =
      ground::kNoLandCover;  ///< Index of the wood in WoodIndex::woods; kNoLandCover: no wood within 6 m.
};

/// Returns the mean of three trees of the wood at `p` or within 6 m of it. Species and heights of the three are drawn
/// from a hash of the coordinates; they are not the trees that are placed there. The result depends on the position and
/// on land cover within 6 m only, so neighbouring tiles agree.
/// @param p      Plane metres.
/// @param month  The month decides leaves and their colours.
CrownAverage crown_average_at(const WoodIndex& woods, Vec2 p, Month month);

}  // namespace citykiln::plants
