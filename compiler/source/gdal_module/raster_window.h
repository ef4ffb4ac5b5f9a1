// Selects the samples of a raster needed for a box of longitudes and latitudes.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source::gdal {

/// A selection of a raster's samples: those at columns column + stride · i for 0 ≤ i < columns and at rows
/// row + stride · j for 0 ≤ j < rows.
struct PixelWindow {
  int column = 0, row = 0;    ///< The first sample.
  int columns = 0, rows = 0;  ///< The number of selected samples; 0 columns: none is needed.
  int stride = 1;             ///< 1: every sample.
};

/// Returns every sample (stride 1) inside `box` and in a margin of 24 samples around it, limited to the raster. Without
/// columns if box and raster do not meet.
/// @param raster  Its columns, rows, from_grid and system_wkt are used, not its heights.
/// Errors: a reference system that cannot be converted, a grid that cannot be inverted.
Result<PixelWindow> window_of(const Raster& raster, const LonLatBox& box);

/// Selects every n-th sample of a window, with the largest n for which selected samples are at most `spacing_m` apart
/// both ways; n = 1 if even neighbours are farther apart. Returns the window unchanged if it has no columns or
/// samples_m is 0 (unknown).
/// @param window     With a stride of 1.
/// @param samples_m  The distances between the file's neighbouring samples, east and north.
PixelWindow thinned(PixelWindow window, Vec2 samples_m, double spacing_m);

}  // namespace citykiln::source::gdal
