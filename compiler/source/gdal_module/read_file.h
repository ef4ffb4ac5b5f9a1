// Reads a heightmap with the few GDAL drivers needed, cut to a window.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source::gdal {

/// Reads an existing file that is not empty. Parameters and errors are those of read_raster().
Result<Raster> read_file(const RasterSpec& spec, const LonLatBox* window, double spacing_m);

}  // namespace citykiln::source::gdal
