// Marks: painted polygons on a strip of road, and functions that make their shapes. u is metres across the strip from
// its left edge, v metres along it. A layout is the set of marks of a strip; it repeats along the strip.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::roads {

/// A polygon of one colour.
struct Mark {
  Ring ring;  ///< Metres (u, v) of the strip, simple, in either direction. May extend beyond the ends of the layout and
              ///< wraps around there.
  materials::TextureImage::Texel colour{};
};
using Marks = std::vector<Mark>;  ///< In painting order: later marks cover earlier ones.

/// Worn white paint, which reflects 0.65 of the light; new paint reflects 0.8.
inline constexpr materials::TextureImage::Texel kWhite = {211, 211, 207};

/// Worn yellow paint of centre lines: darker than white, within the chromaticities of MUTCD's yellow.
inline constexpr materials::TextureImage::Texel kYellow = {205, 160, 52};

/// The rectangle between two opposite corners.
Ring rectangle(Vec2 low, Vec2 high);

/// The dash pattern of a line along the road: dashes of dash_m every period_m, centred in their periods so that the
/// line looks equal from both ends. A line is solid if both are equal. The period divides kLayoutLength_m.
struct DashPattern {
  double dash_m, period_m;
};
inline constexpr DashPattern kSolid = {1, 1};

/// Adds a line along the road, centred at u, over the whole layout.
void add_line(double u_m, double width_m, DashPattern dashes, Marks& marks,
              materials::TextureImage::Texel colour = kWhite);

/// Adds a broken line across the road in the rectangle from u = left_m to right_m and v = low_m to high_m. Dashes and
/// gaps are scaled to the width so that there is a dash at each end.
void add_dashes_across(double left_m, double right_m, double low_m, double high_m, DashPattern dashes, Marks& marks);

/// Returns the outline of a polyline with a width, mitred bends and square ends; a polyline that ends at its start is
/// closed. Consecutive points must differ, and no bend may be sharper than a quarter turn.
Ring stroke(std::span<const Vec2> line, double width);

/// Returns the marks rotated by 180° within the strip: (u, v) becomes (width - u, length - v).
Marks turned_round(const Marks& marks, double width_m, double length_m);

}  // namespace citykiln::roads
