// How much of each texel a polygon covers.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::materials {

/// Texels [first, end) of a sheet's row: what a polygon may touch.
struct ColumnRange {
  std::uint32_t first = 0, end = 0;
};

/// A window of texels: columns as asked for, rows from `first_row` on, all of them in 0 … rows - 1 of the sheet after
/// wrapping.
struct Coverage {
  std::uint32_t first_column = 0, columns = 0;
  std::uint32_t first_row = 0, rows = 0;
  std::vector<double> share;  ///< 0 … 1, row by row: share[r * columns + c].
};

/// The share of each texel's area that lies in the ring: the box filter, exact but for rounding.
///
/// @param ring_m   TextureImage metres, simple, either way round.
/// @param texel_m  > 0.
/// @param rows     Of the sheet. Rows are counted modulo this: what leaves at the end comes in at the start.
///
/// Guarantees: for a ring inside the columns and shorter than the sheet the shares sum to the ring's area in texels, to
/// 1e-9 of the ring's box. Total: a ring with a coordinate that is not finite or beyond 2^30 texels covers nothing,
/// where one runs round more than once, or comes over itself by wrapping, the share is 1. O(texels of its box).
/// Source: signed areas per edge, as in the anti-aliasing rasters of LibArt and FreeType.
Coverage coverage_of(const Ring& ring_m, double texel_m, std::uint32_t rows, ColumnRange columns);

}  // namespace citykiln::materials
