// Joins neighbouring cells of a tile city that have the same cover into areas.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Returns the areas of equal labels on a grid of unit cells, one list of polygons per label. Entry 0 is empty: label 0
/// means no cover. Outer rings are simple and counter-clockwise, holes clockwise; vertices are only at the corners of
/// an area. Two cells that touch in one point are not joined.
///
/// @param labels   Row by row: labels[r * columns + c] is the label of the cell [c, c + 1] × [r, r + 1], with y
///                 upwards, so row 0 lies at the bottom. Each is less than `count`. The size is a multiple of
///                 `columns`.
/// @param columns  > 0.
/// @param count    The number of labels, 0 included: the size of the result.
/// O(cells + holes · polygons of their label).
std::vector<std::vector<Polygon>> join_covers(const std::vector<std::uint32_t>& labels, int columns,
                                              std::uint32_t count);

}  // namespace citykiln::invent
