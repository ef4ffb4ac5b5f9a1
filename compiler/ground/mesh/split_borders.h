// Splits borders where the ground bends under them.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/border.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

struct SplitBorders {
  std::vector<Border> borders;    ///< Those given, split; the cell's own border whole.
  std::vector<GridPoint> points;  ///< On the cell's own border.
};

/// Splits borders.
/// @param heights      One per polygon; kNoLandCover lies on the land.
/// @param sides_m      Tolerance on the cell's border, for all layers.
/// @param inner_m      Tolerance elsewhere, for the layers on both sides; standing water needs no points.
/// Guarantees: how a border is split depends on its ends and on the heights along it alone, so both cells of a common
/// border split it alike; other borders get no point on the cell's. O(points + edges of the reference crossed).
SplitBorders split_borders(const Reference& reference, std::span<const Border> borders,
                           std::span<const FaceHeight> heights, const SideTolerances& sides_m, double inner_m);

}  // namespace citykiln::ground
