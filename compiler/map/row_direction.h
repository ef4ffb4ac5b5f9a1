// Headings of rows of plants. A heading is a number from 0 to 255: the angle counter-clockwise from
// east, in 256ths of half a turn. A direction and its reverse have the same heading.
#pragma once

#include <cstdint>

#include "compiler/geometry/vec.h"

namespace citykiln::map {

/// Returns the heading nearest to a direction, x east and y north, of any length; 0 for {0, 0}. It
/// has the same bits on every CPU.
std::uint8_t row_heading_along(Vec2 direction);

/// Returns the unit vector of a heading, x east and y >= 0 north.
Vec2 row_direction(std::uint8_t heading);

}  // namespace citykiln::map
