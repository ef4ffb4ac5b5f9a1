// An edge between two surfaces of the ground.
#pragma once

#include <cstdint>

#include "compiler/geometry/arrangement.h"

namespace citykiln::ground {

/// A piece of border that is seen, and what lies to its left and right. The cell's own border has nothing on one side,
/// and is not between two surfaces.
struct Border {
  GridPoint a, b;  ///< a < b
  std::uint32_t left = 0, right = 0;
  bool is_cell_border = false;
  bool operator==(const Border&) const = default;
};

}  // namespace citykiln::ground
