// Cells of a grid in Morton order, in which neighbours are near each other.
#pragma once

#include <cstdint>
#include <vector>

namespace citykiln::preview {

/// A cell of a grid: column and row.
struct GridPlace {
  int x = 0, y = 0;
};

/// Returns all cells of a grid in Morton order (Z-order). Sizes up to 65536. O(n log n).
std::vector<GridPlace> in_morton_order(int width, int height);

}  // namespace citykiln::preview
