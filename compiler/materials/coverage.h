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

/// A window of texels. Rows are counted from first_row and wrap around at the end of the image.
struct Coverage {
  std::uint32_t first_column = 0, columns = 0;
  std::uint32_t first_row = 0, rows = 0;
  std::vector<double> share;  ///< 0 … 1, row by row: share[r * columns + c].
};

/// Returns the share of each texel's area that lies in a ring: a box filter, exact except for rounding.
///
/// @param ring_m   A simple ring in image metres, of either orientation.
/// @param texel_m  > 0.
/// @param rows     Rows of the image, > 0; it repeats along v.
///
/// Guarantees: for a ring inside the columns and shorter than the image the shares sum to the ring's area in texels, to
/// 1e-9 of the ring's box. Accepts any ring: one with a coordinate that is not finite or beyond 2^30 texels covers
/// nothing, and the shares of a ring that overlaps itself are limited to 1. O(texels of its box).
/// Source: signed areas per edge, as in the anti-aliasing rasterisers of LibArt and FreeType.
Coverage coverage_of(const Ring& ring_m, double texel_m, std::uint32_t rows, ColumnRange columns);

}  // namespace citykiln::materials
