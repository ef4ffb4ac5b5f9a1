// Measures of a shape that expressions can use.
#pragma once

#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

double surface_m2(const Shape& shape);
/// The height difference between the highest and the lowest vertex; 0 without faces.
double height_m(const Shape& shape);
/// The volume of a closed surface, by the divergence theorem. For an open surface the number has no meaning.
double volume_m3(const Shape& shape);
bool is_rectangular(const Shape& shape);
bool is_concave(const Shape& shape);

}  // namespace citykiln::grammars
