// Marks: polygons of paint on a strip, and the shapes they are made of.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::roads {

/// A polygon of one colour.
struct Mark {
  Ring ring;  ///< Metres of the strip (u, v), simple, either way round. May reach over the ends of the pattern, and
              ///< wraps.
  materials::TextureImage::Texel colour{};
};
using Marks = std::vector<Mark>;  ///< In the order in which they are painted: later over earlier.

/// White paint that has been driven on: new paint reflects 0.8, this 0.65.
inline constexpr materials::TextureImage::Texel kWhite = {211, 211, 207};

/// From corner to corner.
Ring rectangle(Vec2 low, Vec2 high);

/// How a line along the way is broken: dashes of dash_m every period_m, one in the middle of each period, so that the
/// line is the same seen from its other end. Unbroken where both are equal. The period divides kLayoutLength_m.
struct DashPattern {
  double dash_m, period_m;
};
inline constexpr DashPattern kUnbroken = {1, 1};

/// A line along the way about u, over the whole pattern.
void add_line(double u_m, double width_m, DashPattern rhythm, Marks& marks);

/// A broken line across the way, from u = left to right, dashes and gaps as near to what is asked as fits with a dash
/// at each end; v from low to high.
void add_dashes_across(double left_m, double right_m, double low_m, double high_m, DashPattern rhythm, Marks& marks);

/// The outline of a line of this width with mitred bends and square ends; a line that ends where it begins is closed
/// there. No two points in a row are the same, no bend is sharper than a quarter turn.
Ring stroke(std::span<const Vec2> line, double width);

/// The marks turned round within a strip: (u, v) to (width - u, length - v).
Marks turned_round(const Marks& marks, double width_m, double length_m);

}  // namespace citykiln::roads
