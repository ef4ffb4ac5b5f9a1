// The mean height and colour of a wood around a place, seen from above.
#pragma once

#include <array>

#include "compiler/plants/placing/wood_map.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct CrownAverage {
  double height_m = 0;             ///< Mean of trees; 0: no wood is near.
  double chance = 0;               ///< A random number of the place, in [0, 1).
  std::array<double, 3> colour{};  ///< Linear reflectance of crowns and of the ground between them.
  std::uint32_t wood = ground::kNoLandCover;
};

/// The mean of three trees drawn by the place's coordinates: a function of the place and the land cover within 6 m, so
/// that neighbouring tiles agree. O(trees drawn).
CrownAverage crown_average_at(const WoodMap& woods, Vec2 p, Month month);

}  // namespace citykiln::plants
