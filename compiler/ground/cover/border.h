// An edge between two surfaces of the ground.
#pragma once

#include <cstdint>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box.h"

namespace citykiln::ground {

/// A piece of border that is seen, and what lies to its left and right. The cell's own border has nothing on one side,
/// and is not between two surfaces.
struct Border {
  GridPoint a, b;  ///< a < b
  std::uint32_t left = 0, right = 0;
  bool is_cell_border = false;
  bool operator==(const Border&) const = default;
};

/// A piece of the cell's own border along which a ring runs, mostly for some grid steps where snapping has bent it
/// there: the neighbour may have another surface on it.
struct CellBorderPiece {
  GridPoint a, b;            ///< a < b
  std::uint32_t beyond = 0;  ///< What the neighbour has.
  bool operator==(const CellBorderPiece&) const = default;
};

/// A tolerance for each side of a cell. Both cells of a side must be given the same one there.
struct SideTolerances {
  double west_m, east_m, south_m, north_m;
};
inline SideTolerances all_sides(double m) { return {m, m, m, m}; }

/// That of the side on which a piece of the cell's own border lies.
double tolerance_m_of(const SideTolerances& sides, const Border& border, const Box2& cell);

}  // namespace citykiln::ground
