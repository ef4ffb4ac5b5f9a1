// Splits straight lines on the graded terrain where the ground bends under them, so that a triangulation with these
// lines as edges follows the ground.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// Largest error of lines and faces of the reference against the graded terrain where it is sampled; on roads less.
inline constexpr double kReferenceError_m = 0.0625;

/// How finely a line is split.
struct SplitLimits {
  double piece_m = 6;     ///< It is sampled in equal pieces of at most this length.
  double shortest_m = 2;  ///< Shorter pieces are not split.
  double error_m = kReferenceError_m;
};

/// Returns points of the line from a to b, without its ends, in order: where grading bends the ground under it near a
/// cell, on any layer, so that no piece is off by more than limits.error_m unless it is shorter than shortest_m; and
/// the ends of each piece that crosses from cell to cell. The terrain's own bends do not count: they have lines of
/// their own. The points are snapped to the 2^-10 m grid, depend only on the line and on recipes within kGrading_m of
/// the cell, and are the same in both directions, so the cells on both sides of a crossing agree. O(length).
std::vector<Vec2> bend_points_along(GradedHeights& heights, Vec2 a, Vec2 b, const Box2& cell,
                                    const SplitLimits& limits = {});

/// Returns the polygons with bend points added to edges that come near the cell. Roads' polygons stay: they follow
/// their profiles. O(edges).
std::vector<LandCoverPolygon> rings_with_bends(std::span<const LandCoverPolygon> surfaces, GradedHeights& heights,
                                               const Box2& cell);

/// Returns points on a cell's border between which the difference of graded terrain and terrain is linear within
/// kReferenceError_m. They depend on the side alone, so both cells have them; none without grading. O(length).
std::vector<GridPoint> bend_points_on_border(GradedHeights& heights, const Box2& cell);

}  // namespace citykiln::ground
