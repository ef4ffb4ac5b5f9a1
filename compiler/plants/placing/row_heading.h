// The heading of rows of crops, vines and orchard trees: along the contour lines, so that water does not run down
// between rows. A heading is a number from 0 to 255: the angle counter-clockwise from east, in 256ths of half a turn.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::plants {

/// Returns Planting::heading for a polygon: perpendicular to the mean slope of its terrain, or along its longest edge
/// if the slope is below 3 %. O(border points).
std::uint8_t row_heading(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain);

/// Returns the unit vector of a heading, x east and y north.
Vec2 row_direction(std::uint8_t heading);

}  // namespace citykiln::plants
