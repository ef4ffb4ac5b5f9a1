// Points of borders that lie on a straight line between their neighbours.
//
// Borders are made of parts of many lines, and each line that ends on a border leaves a point there.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/faces.h"

namespace citykiln::parcels {

/// Returns points that borders between regions can do without, sorted. Points are on the grid of kQuantum_m.
///
/// @param regions  The region of each face, in the order of Faces::faces. Borders lie between faces of different
///                 regions.
///
/// Guarantees: each point has exactly two border edges. Both are edges of the same thing (equal FaceEdge::border),
/// whether this is a segment of a right-of-way, taken land, or a border between lots. The point lies at most
/// kStraight_m from the straight line between its neighbours. Points are dropped in kStraightRounds rounds, which may
/// together move a border by that many times kStraight_m. Borders without these points do not cross. Whether a point is
/// dropped depends on points within kStraightRounds edges. O(n log n).
std::vector<GridPoint> straight_points(const Faces& faces, const std::vector<std::uint32_t>& regions);

/// The largest distance at which a point counts as on the line: twice the step of the grid, as points are rounded by up
/// to half a step in each direction.
inline constexpr double kStraight_m = 2 * kQuantum_m;
/// The number of rounds. A round drops at most one of two neighbouring points.
inline constexpr int kStraightRounds = 3;

}  // namespace citykiln::parcels
