// Splits straight lines on the graded terrain at places where the ground bends, so that a triangulation with these
// lines as edges follows the ground.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// The largest error of the reference (a cell's ground at full detail, as a triangulation) against samples of the
/// graded terrain. On roads the error is smaller.
inline constexpr double kReferenceError_m = 0.0625;

/// Limits for splitting a line.
struct SplitLimits {
  double piece_m = 6;     ///< Largest length of the equal pieces in which it is sampled.
  double shortest_m = 2;  ///< Shorter pieces are not split.
  double error_m = kReferenceError_m;
};

/// Returns points of the line from a to b near a cell, in order, without the line's ends: the places where grading
/// bends the ground on any height layer (land, road, carriageway or water, height_layer.h), and the ends of each
/// sampled piece that crosses from cell to cell. Between neighbouring points the ground is linear within
/// limits.error_m, unless they are closer than limits.shortest_m. Bends of the terrain itself do not count, since the
/// terrain's grid lines are edges of the reference.
///
/// The points are snapped to the 2^-10 m grid, depend only on the line and on roads and water within kGrading_m of the
/// cell, and are the same in both directions, so the cells on both sides of a crossing agree. O(length).
std::vector<Vec2> bend_points_along(GradedHeights& heights, Vec2 a, Vec2 b, const Box2& cell,
                                    const SplitLimits& limits = {});

/// Returns the polygons with bend points added to edges that come near the cell. Polygons of roads are not changed, as
/// they follow their profiles. O(edges).
std::vector<LandCoverPolygon> rings_with_bends(std::span<const LandCoverPolygon> surfaces, GradedHeights& heights,
                                               const Box2& cell);

/// Returns points on a cell's border between which the difference of graded terrain and terrain is linear within
/// kReferenceError_m; none without grading. They depend on the side only, so both cells have them. O(length).
std::vector<GridPoint> bend_points_on_border(GradedHeights& heights, const Box2& cell);

}  // namespace citykiln::ground
