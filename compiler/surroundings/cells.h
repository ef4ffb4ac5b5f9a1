// Divides the land around the tiles of a scene into squares that grow with their distance from the tiles.
//
//     ┌───────┬───────┐      A square is split into four until its side is at most an eighth of its distance from the
//     │       │   │   │      tiles: a twelfth where the land is rough, a quarter where it is smooth and far. Squares
//     │       ├───┼─┬─┤      beside tiles have the finest side.
//     │       │   ├─┼─▒ tile
//     └───────┴───┴─┴─▒
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "compiler/geometry/box.h"

namespace citykiln::surroundings {

/// A square: its south-western corner and its side, whole metres.
struct Cell {
  std::int32_t x_m = 0, y_m = 0, side_m = 0;

  Vec2 low() const { return {static_cast<double>(x_m), static_cast<double>(y_m)}; }
  Box2 box() const { return {low(), low() + Vec2{static_cast<double>(side_m), static_cast<double>(side_m)}}; }
};

/// The side of the largest squares, and the sides that they have as a share of their distance from the tiles.
inline constexpr std::int32_t kLargestCell_m = 4096;
inline constexpr double kShareOfDistance = 1.0 / 8, kShareWhereRough = 1.0 / 12;
/// From this distance on, patches of land cover are hardly seen, and smooth land has larger squares.
inline constexpr double kPlainFrom_m = 1500, kShareOfPlain = 1.0 / 4;

/// The side of squares of open sea as a share of their distance.
inline constexpr double kShareOfSea = 1.0 / 2;

/// The facts that the sides of squares depend on.
struct CellSizes {
  std::int32_t finest_m = 32;                 ///< Divides the sides of tiles; a power of two.
  std::function<double(const Box2&)> away_m;  ///< The distance of a box from the tiles; 0 where they touch.
  std::function<bool(const Box2&)> is_rough;  ///< True if the land of a box is far from a plane.
  std::function<bool(const Box2&)> is_sea;    ///< True if a box is open sea. Empty: no box is.
};

/// Returns the squares that cover a box, sorted by place within each of the largest. Beside the tiles all have the
/// finest side, so that none is partly in a tile. On land the sides of neighbours differ by a factor of four at most.
std::vector<Cell> cells_over(const Box2& box, const CellSizes& sizes);

/// Finds squares by place.
class CellIndex {
 public:
  explicit CellIndex(const std::vector<Cell>& cells);
  /// Returns the number of the square that holds a place; kNone outside of all.
  std::uint32_t at(Vec2 place) const;
  static constexpr std::uint32_t kNone = 0xffffffffu;

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> by_corner_;
  std::vector<std::int32_t> sides_m_;  // those that occur, ascending
};

}  // namespace citykiln::surroundings
