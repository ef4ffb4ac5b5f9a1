// What expressions can measure of a shape.
#pragma once

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

double surface_m2(const Shape& shape);
/// From the lowest to the highest vertex; 0 without faces.
double height_m(const Shape& shape);
/// By the divergence theorem: of a closed surface its volume, of another one no more than a number.
double volume_m3(const Shape& shape);
bool is_rectangular(const Shape& shape);
bool is_concave(const Shape& shape);

}  // namespace citykiln::grammars
