// Tolerances: the largest distance between a simplified shape and the full shape (Hausdorff distance), in metres.
#pragma once

#include <array>

namespace citykiln {

/// Tolerances in metres, finest first. The finest stands for the full shape. The levels of a compile are
/// kDefaultLevels_m (spec.h).
inline constexpr std::array kFinestTolerances_m = {0.02, 0.1, 0.5, 2.5, 12.5};

/// The largest tolerance of a level, in metres. Beyond it nothing of a city is left but the ground.
inline constexpr double kCoarsest_m = 100;

/// The grid step of the coordinates of baked vertices, in metres. It is a power of two, so that offsets from a tile's
/// origin are exact in single precision up to 16 km.
inline constexpr double kQuantum_m = 0x1p-10;

}  // namespace citykiln
