// Terrarium: https://github.com/tilezen/joerd/blob/master/docs/formats.md. Mapbox:
// https://docs.mapbox.com/data/tilesets/guides/access-elevation-data.
#include "compiler/source/gdal_module/raster_samples.h"

#include <gdal_priv.h>

#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/source/gdal_module/quiet_gdal.h"

namespace citykiln::source::gdal {
namespace {

// SRTM's value for voids, used even where the file declares none
constexpr double kSrtmVoid = -32768;
// larger values are heights in no unit: they are undeclared nodata values
constexpr double kNoHeight = 1e9;

// Reads whole rows and keeps every n-th sample: GDAL's own thinning would read means from overviews, where there are
// any.
bool read_thinned(GDALRasterBand& band, const PixelWindow& window, std::vector<double>& values) {
  const int across = (window.columns - 1) * window.stride + 1;
  std::vector<double> row(static_cast<std::size_t>(across));
  for (int r = 0; r < window.rows; ++r) {
    const int y = window.row + r * window.stride;
    if (band.RasterIO(GF_Read, window.column, y, across, 1, row.data(), across, 1, GDT_Float64, 0, 0, nullptr) !=
        CE_None)
      return false;
    for (int c = 0; c < window.columns; ++c)
      values[static_cast<std::size_t>(r) * window.columns + c] = row[static_cast<std::size_t>(c) * window.stride];
  }
  return true;
}

// Reads a window of one band as doubles. Returns false on failure.
bool read_band(GDALRasterBand& band, const PixelWindow& window, std::vector<double>& values) {
  values.resize(static_cast<std::size_t>(window.columns) * window.rows);
  if (window.stride > 1) return read_thinned(band, window, values);
  return band.RasterIO(GF_Read, window.column, window.row, window.columns, window.rows, values.data(), window.columns,
                       window.rows, GDT_Float64, 0, 0, nullptr) == CE_None;
}

double nodata_of(GDALRasterBand& band) {
  int has_nodata = 0;
  const double nodata = band.GetNoDataValue(&has_nodata);
  return has_nodata ? nodata : std::numeric_limits<double>::quiet_NaN();
}

bool is_void(double value, double nodata) {
  return !std::isfinite(value) || value == nodata || value == static_cast<double>(static_cast<float>(nodata)) ||
         value == kSrtmVoid || std::abs(value) > kNoHeight;
}

Error unreadable(const RasterSpec& spec, const QuietGdal& quiet) {
  return {spec.path, "the samples cannot be read; is the file cut off? Load it again: " + quiet.last_message()};
}

Result<std::vector<float>> read_plain(GDALDataset& dataset, const PixelWindow& window, const RasterSpec& spec) {
  const QuietGdal quiet;
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  std::vector<double> values;
  if (!read_band(band, window, values)) return unreadable(spec, quiet);
  const double nodata = nodata_of(band), band_scale = band.GetScale(), band_offset = band.GetOffset();
  std::vector<float> heights_m;
  heights_m.reserve(values.size());
  for (const double value : values) {
    const double height_m = spec.scale * (band_scale * value + band_offset) + spec.offset_m;
    heights_m.push_back(is_void(value, nodata) ? kVoid : static_cast<float>(height_m));
  }
  return heights_m;
}

double decode_height(const std::string& encoding, double red, double green, double blue) {
  if (encoding == "terrarium") return 256 * red + green + blue / 256 - 32768;
  return -10000 + 0.1 * (65536 * red + 256 * green + blue);
}

Result<std::vector<float>> read_coloured(GDALDataset& dataset, const PixelWindow& window, const RasterSpec& spec) {
  const QuietGdal quiet;
  std::vector<double> red, green, blue, alpha;
  const bool is_read = read_band(*dataset.GetRasterBand(1), window, red) &&
                       read_band(*dataset.GetRasterBand(2), window, green) &&
                       read_band(*dataset.GetRasterBand(3), window, blue) &&
                       (dataset.GetRasterCount() < 4 || read_band(*dataset.GetRasterBand(4), window, alpha));
  if (!is_read) return unreadable(spec, quiet);
  std::vector<float> heights_m;
  heights_m.reserve(red.size());
  for (std::size_t i = 0; i < red.size(); ++i) {
    const bool is_transparent = !alpha.empty() && alpha[i] == 0;
    const double height_m = spec.scale * decode_height(spec.encoding, red[i], green[i], blue[i]) + spec.offset_m;
    heights_m.push_back(is_transparent ? kVoid : static_cast<float>(height_m));
  }
  return heights_m;
}

std::vector<double> codes_of(GDALDataType type) {
  switch (type) {
    case GDT_Byte:
      return {0, 255};
    case GDT_UInt16:
      return {0, 65535};
    case GDT_Int16:
      return {0, 32767, -32767};
    default:
      return {0};
  }
}

}  // namespace

std::vector<float> code_heights_m(GDALRasterBand& band, const RasterSpec& spec) {
  std::vector<float> heights_m;
  if (!spec.encoding.empty()) return heights_m;
  for (const double code : codes_of(band.GetRasterDataType()))
    heights_m.push_back(static_cast<float>(spec.scale * (band.GetScale() * code + band.GetOffset()) + spec.offset_m));
  return heights_m;
}

Result<std::vector<float>> read_samples(GDALDataset& dataset, const PixelWindow& window, const RasterSpec& spec) {
  assert(window.column >= 0 && window.column + (window.columns - 1) * window.stride < dataset.GetRasterXSize());
  assert(window.row >= 0 && window.row + (window.rows - 1) * window.stride < dataset.GetRasterYSize());
  const int bands = dataset.GetRasterCount();
  GDALRasterBand& first = *dataset.GetRasterBand(1);
  if (spec.encoding.empty()) {
    if (first.GetColorTable()) return Error{spec.path, "a picture with a colour palette contains no heights"};
    if (bands > 2) return Error{spec.path, "a colour picture needs encoding=terrarium or encoding=mapbox"};
    return read_plain(dataset, window, spec);
  }
  if (bands < 3 || first.GetRasterDataType() != GDT_Byte) {
    return Error{spec.path, "encoding=" + spec.encoding + " needs three bands with 8 bits each"};
  }
  return read_coloured(dataset, window, spec);
}

}  // namespace citykiln::source::gdal
