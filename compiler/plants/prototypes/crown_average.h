// What stands about a place of a wood, on the mean: how high, and how it looks from above.
#pragma once

#include <array>

#include "compiler/plants/placing/wood_map.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct CrownAverage {
  double height_m = 0;             ///< Of trees; 0: no wood is near.
  double chance = 0;               ///< The place's own die, 0 to 1.
  std::array<double, 3> colour{};  ///< Linear reflectance of crowns, and of the ground that is seen between.
  std::uint32_t wood = ground::kNoLandCover;
};

/// Trees that a wood would have at the place, drawn by its coordinates: a function of the place and of what lies within
/// a few metres, so that tiles agree where they meet. O(trees drawn).
CrownAverage crown_average_at(const WoodMap& woods, Vec2 p, Month month);

}  // namespace citykiln::plants
