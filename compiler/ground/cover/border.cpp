#include "compiler/ground/cover/border.h"

#include <cassert>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::ground {

std::vector<GridPoint> ends_of(std::span<const Border> borders) {
  std::vector<GridPoint> ends;
  for (const Border& border : borders) ends.insert(ends.end(), {border.a, border.b});
  sort_unique(ends);
  return ends;
}

double tolerance_m_of(const SideTolerances& sides, const Border& border, const Box2& cell) {
  assert(border.is_cell_border);
  const GridPoint min = grid_point(cell.min);
  if (border.a.x == border.b.x) return border.a.x == min.x ? sides.west_m : sides.east_m;
  return border.a.y == min.y ? sides.south_m : sides.north_m;
}

}  // namespace citykiln::ground
