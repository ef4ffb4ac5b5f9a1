// Area coverage of texels by a polygon.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::materials {

/// The columns [first, end) of an image that a polygon may affect.
struct ColumnRange {
  std::uint32_t first = 0, end = 0;
};

/// A window of texels of an image. Row r and column c of the window are column first_column + c and row (first_row + r)
/// modulo the number of rows of the image. Texel (0, 0) of the image covers u and v from 0 to texel_m, as in
/// TextureImage.
struct Coverage {
  std::uint32_t first_column = 0, columns = 0;
  std::uint32_t first_row = 0, rows = 0;
  std::vector<double> share;  ///< 0 … 1, row by row: share[r * columns + c].
};

/// Returns the share of each texel's area that lies in a ring: a box filter, exact except for rounding. The window is
/// the ring's box, limited to `columns` and to `rows` rows; it has no texels if nothing is covered.
///
/// @param ring_m   Metres on the image, clockwise or counter-clockwise: x is u, y is v. Any v is allowed, as the image
///                 repeats along v.
/// @param texel_m  The size of a texel.
/// @param rows     Rows of the image.
///
/// Guarantees: for a simple ring inside the columns and no longer along v than the image, the shares sum to the ring's
/// area in texels, to 1e-9 of the ring's box. Other input is accepted too. For a ring that is not simple, or is longer
/// than the image, a share is the sum of winding numbers over the texel, without its sign and limited to 1. Fewer than
/// three points, a coordinate that is not finite or beyond 2^30 texels, no rows or columns, and a texel_m that is not
/// above 0 cover nothing. O(texels of its box).
/// Source: signed areas per edge, as in the anti-aliasing rasterisers of LibArt and FreeType.
Coverage coverage_of(const Ring& ring_m, double texel_m, std::uint32_t rows, ColumnRange columns);

}  // namespace citykiln::materials
