// Which way rows run: along the contour, so that no water runs down between them.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"

namespace citykiln::plants {

/// The heading of Planting: square to the mean slope of the terrain under a surface; where that is less than 3 in a
/// hundred, along the surface's longest border. O(border + 256).
std::uint8_t row_heading(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain);

/// Along rows of a heading; length 1.
Vec2 row_direction(std::uint8_t heading);

}  // namespace citykiln::plants
