// Converts the bands of a raster to heights in metres.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/gdal_module/raster_window.h"
#include "compiler/source/raster.h"

class GDALDataset;

namespace citykiln::source::gdal {

/// Returns the heights of the window, row by row. Voids (the file's nodata value, -32768, transparent pixels,
/// non-finite values) become NaN. Without an encoding height_m = scale * value + offset of the one band; terrarium:
/// value = 256 R + G + B / 256 - 32768; mapbox: value = -10000 + 0.1 * (65536 R + 256 G + B). Errors: bands that do not
/// fit the encoding, unreadable data.
Result<std::vector<float>> read_samples(GDALDataset& dataset, const PixelWindow& window, const RasterSpec& spec);

}  // namespace citykiln::source::gdal
