// Borders take points where the ground bends under them.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/border.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

struct SplitBorders {
  std::vector<Border> borders;    ///< Those given, cut; the cell's own border whole.
  std::vector<GridPoint> points;  ///< On the cell's own border.
};

/// @param heights      Of each surface; kNoLandCover lies on the land.
/// @param sides_m      How far the cell's border may be off, in any layer.
/// @param inner_m      How far others may be off, in the layers on both sides; standing water asks for no point.
/// Guarantees: a border is cut by its ends and by the heights along it alone, so both cells of a common border cut it
/// alike. O(points + the reference's edges crossed).
SplitBorders split_at_bends(const Reference& reference, std::span<const Border> borders,
                            std::span<const FaceHeight> heights, const SideTolerances& sides_m, double inner_m);

}  // namespace citykiln::ground
