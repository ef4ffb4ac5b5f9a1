// Points of borders that lie on a straight line between their neighbours.
//
// Borders are made of parts of many lines, and each line that ends on a border leaves a point there.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/faces.h"

namespace citykiln::parcels {

/// Returns points that borders between regions can do without, sorted.
///
/// @param regions  The region of each face. Borders lie between faces of different regions.
/// Guarantees: each point has exactly two border edges, both along the same line, taken land or lot, and lies at most
/// kStraight_m from the straight line between its neighbours. kStraightRounds rounds may together move a border by that
/// many times kStraight_m. Borders without these points do not cross. A point depends on points within kStraightRounds
/// edges. O(n log n).
std::vector<GridPoint> straight_points(const Faces& faces, const std::vector<std::uint32_t>& regions);

/// Twice the step of the grid: points are rounded by up to half of it in each direction.
inline constexpr double kStraight_m = 2 * kQuantum_m;
/// Each round drops at most one of two neighbours.
inline constexpr int kStraightRounds = 3;

}  // namespace citykiln::parcels
