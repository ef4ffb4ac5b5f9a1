// The heading of rows of crops, vines and orchard trees: along the contour lines, so that water does not run down
// between rows.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::plants {

/// Returns Planting::heading (map/row_direction.h) for a polygon: perpendicular to the mean slope of its terrain, or
/// along its longest edge if the slope is below 3 %. O(border points).
std::uint8_t row_heading(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain);

}  // namespace citykiln::plants
