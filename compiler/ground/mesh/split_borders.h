// Splits borders between land cover polygons so that their heights follow the reference (the graded terrain of a cell
// at full detail).
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/border.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// The result of split_borders().
struct SplitBorders {
  std::vector<Border> borders;    ///< The given borders, split, except for the cell's own border.
  std::vector<GridPoint> points;  ///< Points that split the cell's own border.
};

/// Splits borders until their errors are within the tolerances, all in metres. An error is the largest vertical
/// distance between a border and the reference.
///
/// @param borders  Borders inside the cell, and the cell's own.
/// @param heights  Height layer or water level of each polygon. Faces without a polygon lie on the land.
/// @param sides_m  Tolerances on the cell's border, for all layers.
/// @param inner_m  Tolerance of other borders, for the layers on both sides. Standing water needs no points.
///
/// Guarantees: the points of a border depend only on its ends and on the heights along it, so both cells of a common
/// border split it alike; other borders get no point on the cell's border. O(points + edges of the reference crossed).
SplitBorders split_borders(const Reference& reference, std::span<const Border> borders,
                           std::span<const FaceHeight> heights, const SideTolerances& sides_m, double inner_m);

}  // namespace citykiln::ground
