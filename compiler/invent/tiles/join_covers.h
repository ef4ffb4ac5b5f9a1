// Joins the covers of neighbouring cells of a tile city into areas.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Returns the polygons of each label over a grid of unit cells, row by row; label 0 is no cover. Cells that touch at a
/// corner only are apart. Rings are simple and have vertices at corners only. O(cells).
/// @param count  The number of labels, 0 included.
std::vector<std::vector<Polygon>> join_covers(const std::vector<std::uint32_t>& labels, int columns,
                                              std::uint32_t count);

}  // namespace citykiln::invent
