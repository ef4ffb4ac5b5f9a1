// Converts the bands of a raster to heights in metres.
#pragma once

#include <vector>

#include "compiler/contract/result.h"
#include "compiler/source/gdal_module/raster_window.h"
#include "compiler/source/raster.h"

class GDALDataset;
class GDALRasterBand;

namespace citykiln::source::gdal {

/// Returns the heights of the window, row by row: height_m = scale * value + offset, by the spec. Voids become NaN.
/// Without an encoding the value is that of the first band, after the band's own scale and offset; voids are the file's
/// nodata value, -32768, non-finite values and those beyond 1e9. terrarium: value = 256 R + G + B / 256 - 32768;
/// mapbox: value = -10000 + 0.1 * (65536 R + 256 G + B); voids are transparent pixels. Errors: bands that do not fit
/// the encoding, unreadable data.
Result<std::vector<float>> read_samples(GDALDataset& dataset, const PixelWindow& window, const RasterSpec& spec);

/// Returns the heights of a band's values 0 and, of whole numbers with 8 or 16 bits, the ends of their type; none for
/// encoded bands.
std::vector<float> code_heights_m(GDALRasterBand& band, const RasterSpec& spec);

}  // namespace citykiln::source::gdal
