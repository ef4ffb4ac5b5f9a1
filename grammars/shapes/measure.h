// Measurements of a shape, for the values geometry.… of expressions.
#pragma once

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Returns the area of all faces.
double surface_m2(const Shape& shape);
/// Returns the height difference between the highest and the lowest vertex; 0 without faces.
double height_m(const Shape& shape);
/// Returns the volume of a closed surface, by the divergence theorem. Undefined for an open surface.
double volume_m3(const Shape& shape);
/// True if the shape is one rectangular face.
bool is_rectangular(const Shape& shape);
/// True if a face of the shape is not convex.
bool is_concave(const Shape& shape);

}  // namespace citykiln::grammars
