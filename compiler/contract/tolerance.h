// Tolerances: the largest distance between a simplified shape and the full-detail shape (Hausdorff), in metres.
#pragma once

#include <array>

namespace citykiln {

/// The default tolerances of the levels of detail, finest first, metres.
inline constexpr std::array kDefaultLadder_m = {0.02, 0.1, 0.5, 2.5, 12.5};

/// The largest tolerance of a level, metres: beyond it nothing of a city is left but the ground.
inline constexpr double kCoarsest_m = 100;

/// The grid step of coordinates and heights of baked vertices. A power of two, so that float32 offsets from a tile's
/// origin are exact up to 16 km.
inline constexpr double kQuantum_m = 0x1p-10;

}  // namespace citykiln
