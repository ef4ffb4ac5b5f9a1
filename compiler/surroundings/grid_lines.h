// The lines of the grid around an extent.
#pragma once

#include <cstdint>
#include <vector>

namespace citykiln::surroundings {

/// The grid ends so far from the extent: an eye at 280 m sees to there over the sea.
inline constexpr double kReach_m = 60000;
/// Cells beside the extent, and a cell's share of its distance from it: 2.5 km at the end, 2.4° for an eye in the
/// extent.
inline constexpr int kFinestCell_m = 64;
inline constexpr double kCellShare = 1.0 / 24;

/// The lines that cross an axis: borders of the extent and of its tiles, multiples of 128 m or coarser between them,
/// and beyond the extent steps that grow with the distance. Ascending. At most some 230 beyond it and 64 in it, or as
/// many as it has tiles.
/// @param low_m, high_m  The extent's sides, whole multiples of map::kCell_m, as is `tile_m`.
std::vector<std::int32_t> lines_for(double low_m, double high_m, double tile_m);

}  // namespace citykiln::surroundings
