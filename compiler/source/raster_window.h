// Which samples of a raster a box of longitudes and latitudes needs.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// Columns [column, column + columns) and rows likewise; no columns where nothing is needed.
struct PixelWindow {
  int column = 0, row = 0, columns = 0, rows = 0;
};

/// The samples inside `box` and a margin of 16 around it, within the raster.
/// @param raster  With columns, rows, from_grid and system_wkt; heights are not looked at.
/// Errors: a reference system that cannot be reached, a grid that cannot be inverted.
Result<PixelWindow> window_of(const Raster& raster, const LonLatBox& box);

}  // namespace citykiln::source
