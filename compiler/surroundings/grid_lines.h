// The lines of the grid around an extent.
#pragma once

#include <cstdint>
#include <vector>

namespace citykiln::surroundings {

/// The distance of the grid's border from the extent: the horizon at sea of an eye at 280 m.
inline constexpr double kReach_m = 60000;
/// The width of cells beside the extent, and the width of farther cells as a share of their distance from it: 2.5 km at
/// the grid's border, 2.4° for an eye in the extent.
inline constexpr int kFinestCell_m = 64;
inline constexpr double kCellShare = 1.0 / 24;

/// Returns the coordinates of the grid's lines along x or y, ascending: borders of the extent and of its tiles,
/// multiples of 128 m or a coarser step between them, and beyond the extent steps that grow with the distance. There
/// are about 230 lines beyond the extent, and in it at most 64, or as many as it has tiles.
/// @param low_m, high_m  The sides of the extent, whole multiples of map::kCell_m.
/// @param tile_m         The side of a tile, a whole multiple of map::kCell_m.
std::vector<std::int32_t> lines_for(double low_m, double high_m, double tile_m);

}  // namespace citykiln::surroundings
