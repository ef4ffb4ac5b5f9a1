// Straight lines that lie on the graded terrain are cut where it bends under them, so that what is triangulated between
// them follows it.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// What lines and faces may stray from the graded terrain where they are looked at.
inline constexpr double kReferenceError_m = 0.0625;

/// How closely a line is followed.
struct SplitLimits {
  double piece_m = 6;     ///< It is looked at in equal pieces of at most this length.
  double shortest_m = 2;  ///< Shorter pieces are not cut.
  double error_m = kReferenceError_m;
};

/// Points of the line from a to b, both left out, in order: where the ground bends under it near a cell, on any layer,
/// so that none of its pieces there strays by more than is allowed or is shorter than that; and some metres
/// before and after every crossing from cell to cell. The bends of the terrain itself do not count: they have lines of
/// their own. Points are snapped to the 2^-10 m grid, depend on the line and on what is carved within kGrading_m of the
/// cell alone, and are the same whichever way it runs, so cells agree where it leaves the one for the other. O(length).
std::vector<Vec2> bend_points_along(GradedHeights& heights, Vec2 a, Vec2 b, const Box2& cell,
                                    const SplitLimits& limits = {});

/// Surfaces with points in those edges of their rings that come near the cell. Roads' are left as they are: they follow
/// their profiles. O(edges).
std::vector<LandCoverPolygon> rings_with_bends(std::span<const LandCoverPolygon> surfaces, GradedHeights& heights,
                                               const Box2& cell);

/// Points on a cell's border: between them the graded terrain strays from the terrain by what is linear. They depend on
/// the side alone, so both cells have them; none where nothing is carved. O(1).
std::vector<GridPoint> bend_points_on_border(GradedHeights& heights, const Box2& cell);

}  // namespace citykiln::ground
