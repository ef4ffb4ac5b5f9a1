// The mean height and colour of a wood around a position, seen from above.
#pragma once

#include <array>

#include "compiler/plants/placing/wood_map.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct CrownAverage {
  double height_m = 0;             ///< The mean height of trees; 0: no wood is near.
  double chance = 0;               ///< A random number of the position, in [0, 1).
  std::array<double, 3> colour{};  ///< The linear reflectance of crowns and of the ground between them.
  std::uint32_t wood = ground::kNoLandCover;
};

/// Returns the mean of three trees that are drawn by the coordinates of `p`. It depends only on the position and the
/// land cover within 6 m, so neighbouring tiles agree. O(trees drawn).
CrownAverage crown_average_at(const WoodMap& woods, Vec2 p, Month month);

}  // namespace citykiln::plants
