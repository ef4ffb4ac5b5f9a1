// Selects the samples of a raster needed for a box of longitudes and latitudes.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source::gdal {

/// The samples at columns column + stride · i for all i from 0 below `columns`, and at rows chosen in this way; no
/// columns if no sample is needed.
struct PixelWindow {
  int column = 0, row = 0, columns = 0, rows = 0;
  int stride = 1;  ///< 1: every sample.
};

/// The samples inside `box` and a margin of 24 samples around it, limited to the raster.
/// @param raster  Its columns, rows, from_grid and system_wkt are used, not its heights.
/// Errors: a reference system that cannot be converted, a grid that cannot be inverted.
Result<PixelWindow> window_of(const Raster& raster, const LonLatBox& box);

/// Selects every n-th sample of a window, with the largest n whose samples are not farther apart than `spacing_m`; at
/// least 1.
/// @param samples_m  The distances between the file's samples to the east and north.
PixelWindow thinned(PixelWindow window, Vec2 samples_m, double spacing_m);

}  // namespace citykiln::source::gdal
