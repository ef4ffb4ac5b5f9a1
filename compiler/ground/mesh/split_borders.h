// Splits borders where the ground bends under them.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/cover/border.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// Splits the cell's own border where the ground bends under it, as split_borders() does; other borders stay. Borders
/// that are simplified afterwards keep clear of its vertices: one that passed too closely would be bent through them,
/// and what lies beside the cell's border there would not be what the neighbouring cell expects.
std::vector<Border> split_cell_border(const Reference& reference, std::span<const Border> borders,
                                      const SideTolerances& sides_m);

struct SplitBorders {
  std::vector<Border> borders;    ///< Those given, split; the cell's own border whole.
  std::vector<GridPoint> points;  ///< On the cell's own border.
};

/// Splits borders.
/// @param heights      One per polygon; kNoLandCover lies on the land.
/// @param sides_m      Tolerance on the cell's border, for all layers.
/// @param inner_m      Tolerance elsewhere, for the layers on both sides; standing water needs no points.
/// Guarantees: how a border is split depends on its ends and on the heights along it alone, so both cells of a common
/// border split it alike; a border that would be bent onto the cell's by its points is not split. O(points + edges of
/// the reference crossed), and points on the cell's border for each border that is split.
SplitBorders split_borders(const Reference& reference, std::span<const Border> borders,
                           std::span<const FaceHeight> heights, const SideTolerances& sides_m, double inner_m);

}  // namespace citykiln::ground
