// Heading of rows: along the contour lines, so that water does not run down between rows.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"

namespace citykiln::plants {

/// Planting::heading: perpendicular to the mean slope of the terrain in a polygon; where the slope is below 3 %, along
/// the polygon's longest edge. O(border points).
std::uint8_t row_heading(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain);

/// The unit direction of a heading.
Vec2 row_direction(std::uint8_t heading);

}  // namespace citykiln::plants
