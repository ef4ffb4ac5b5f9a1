// Selects the samples of a raster needed for a box of longitudes and latitudes.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// Columns [column, column + columns) and rows [row, row + rows); no columns if no sample is needed.
struct PixelWindow {
  int column = 0, row = 0, columns = 0, rows = 0;
};

/// The samples inside `box` and a margin of 16 samples around it, limited to the raster.
/// @param raster  Its columns, rows, from_grid and system_wkt are used, not its heights.
/// Errors: a reference system that cannot be converted, a grid that cannot be inverted.
Result<PixelWindow> window_of(const Raster& raster, const LonLatBox& box);

}  // namespace citykiln::source
