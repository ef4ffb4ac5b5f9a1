// Windows of buildings beyond the edge: one small picture that all their walls share.
//
//     ┌───────────┐      The upper part of the picture has rows of windows, the lower part is plain wall. A wall shows
//     as │ ▪ ▪ ▪ ▪ ▪ │      many columns, and as many of the lowest rows, as it has bays and storeys. A gable, and the
//     part │ ▪ ▪ ▪ ▪ ▪ │      of a wall below the ground, show plain wall. │___________│ ground └───────────┘
#pragma once

#include <array>

#include "compiler/impostor/atlas.h"

namespace citykiln::bake {

/// The columns of the picture, which two neighbouring walls share, and its rows.
inline constexpr int kMostBays = 24, kMostStoreys = 10;
/// The usual width of a bay and height of a storey. Walls are stretched to whole bays and storeys.
inline constexpr double kBay_m = 3.2, kStorey_m = 3.1;

/// Returns the picture, 192 × 104 texels of 0.4 m. Walls are white, so that tints give their colour. Same bytes on
/// every CPU.
impostor::Atlas far_windows();

/// The part of the picture that the walls of a box show, metres on the picture: u from the left edge, v down from the
/// top. Neighbouring walls have the same u at their common corner, so that they share vertices; two are mirrored.
struct FarWindowPart {
  std::array<double, 4> corners_m{};  ///< u of the corners, in order. Differences are whole numbers of bays.
  double eaves_m = 0, foot_m = 0;     ///< v of the eaves and of the ground.
  double below_m = 0;                 ///< v of the foot of the walls below ground.
};

/// Returns the part for a box.
/// @param length_m  From its first corner to its second, > 0; from the second to the third it has width_m, > 0.
/// @param height_m  From the ground to the eaves, > 0.
/// @param below_m   The depth of its foot below the ground.
FarWindowPart window_part(double length_m, double width_m, double height_m, double below_m);

}  // namespace citykiln::bake
