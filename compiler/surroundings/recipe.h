// The land and sea around the extent: a grid of heights whose cells grow with their distance from the extent.
//
//      ┆  ┆ ┆┆┌────────┐┆┆ ┆  ┆
//     ─┼──┼─┼┼┤ extent ├┼┼─┼──┼─      lines run through; rows and columns are 64 m wide beside the extent, 2.5 km
//      ┆  ┆ ┆┆└────────┘┆┆ ┆  ┆       at the end
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"

namespace citykiln::surroundings {

/// The kind of surface at a vertex of the grid.
enum class Cover : std::uint8_t { kLand, kSea, kLake, kCount };

/// True for the sea and for lakes that go on beyond the extent.
inline bool is_open_water(Cover cover) { return cover == Cover::kSea || cover == Cover::kLake; }

/// Heights at the crossings of lines. Each cell is split by its diagonal from south-west to north-east. Heights are not
/// lowered by the Earth's curvature (curvature.h).
struct Surroundings {
  std::vector<std::int32_t> x_m, y_m;   ///< Coordinates of the lines, plane metres, ascending. Both empty: no grid.
  std::vector<std::int32_t> heights_m;  ///< Above sea level, row by row from the south; 0 at sea; a lake is level.
  std::vector<Cover> covers;            ///< One per height, in the same order.
  /// The largest and the root mean square vertical distance from samples of heightmaps beyond the extent to the grid.
  /// Counts only heightmaps in degrees. Rounded up to whole metres.
  double error_m = 0, rms_error_m = 0;
  bool operator==(const Surroundings&) const = default;

  bool is_empty() const { return heights_m.empty(); }
  std::size_t columns() const { return x_m.size(); }
  std::size_t rows() const { return y_m.size(); }
  std::size_t index(std::size_t column, std::size_t row) const { return row * columns() + column; }
  Vec2 vertex(std::size_t column, std::size_t row) const {
    return {static_cast<double>(x_m[column]), static_cast<double>(y_m[row])};
  }
  Box2 box() const { return {vertex(0, 0), vertex(columns() - 1, rows() - 1)}; }
};

/// True if the lists are consistent: at least two lines each way, ascending and within kFarthest_m of the plane's
/// origin, a known cover and a height within kHighest_m at each crossing, errors that are not negative. An empty grid
/// is consistent, too.
bool is_sound(const Surroundings& around);

inline constexpr double kFarthest_m = 0x1p20, kHighest_m = 10000;
/// The largest number of lines each way.
inline constexpr std::size_t kMostLines = 4096;

/// Returns the height of the grid at a place; outside of the grid, the height at the nearest place of the grid. O(log
/// n).
/// @param around  Not empty.
double height_m_at(const Surroundings& around, Vec2 place);
/// Returns the cover of the vertex nearest to a place; outside of the grid, of a vertex on its border.
Cover cover_at(const Surroundings& around, Vec2 place);

}  // namespace citykiln::surroundings
