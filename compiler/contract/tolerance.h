// Tolerances: the largest distance between a simplified shape and the full shape (Hausdorff distance), in metres.
#pragma once

namespace citykiln {

/// The tolerance that stands for the full shape, in metres.
inline constexpr double kFinestTolerance_m = 0.02;

/// The tolerance of the coarsest default level (kDefaultLevels_m of spec.h), in metres. A single house is a few pixels
/// where it is shown, so details that stand for many houses begin beyond it.
inline constexpr double kCoarsestDefault_m = 12.5;

/// The largest tolerance of a level, in metres. Beyond it nothing of a city is left but the ground.
inline constexpr double kCoarsest_m = 100;

/// The grid step of the coordinates of baked vertices, in metres. It is a power of two, so that offsets from a tile's
/// origin are exact in single precision up to 16 km.
inline constexpr double kQuantum_m = 0x1p-10;

}  // namespace citykiln
