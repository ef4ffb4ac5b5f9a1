#include "compiler/source/gdal_module/read_file.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

#include "compiler/source/gdal_module/quiet_gdal.h"
#include "compiler/source/gdal_module/raster_samples.h"
#include "compiler/source/gdal_module/raster_system.h"
#include "compiler/source/gdal_module/raster_window.h"

namespace citykiln::source::gdal {
namespace {

namespace fs = std::filesystem;

// half the circumference of the Earth in Web Mercator
constexpr double kMercatorHalf_m = 20037508.342789244;

// registering all of GDAL's drivers would take 70 ms
void register_drivers() {
  GDALRegister_SRTMHGT();
  GDALRegister_GTiff();
  GDALRegister_AAIGrid();
  GDALRegister_PNG();
}

bool has_suffix(std::string path, std::string_view suffix) {
  std::transform(path.begin(), path.end(), path.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return path.ends_with(suffix);
}

// GDAL's path of the heightmap inside a zip archive.
std::optional<std::string> name_in_zip(const std::string& path) {
  const std::string archive = "/vsizip/{" + path + "}";
  const CPLStringList entries(VSIReadDirRecursive(archive.c_str()));
  for (const char* suffix : {".hgt", ".tif", ".tiff", ".asc", ".png"}) {
    for (int i = 0; i < entries.size(); ++i) {
      if (has_suffix(entries[i], suffix)) return archive + "/" + entries[i];
    }
  }
  return std::nullopt;
}

Result<GDALDatasetUniquePtr> open(const std::string& path) {
  register_drivers();
  const QuietGdal quiet;
  std::optional<std::string> name = fs::absolute(path).string();
  // the driver of .hgt reads .hgt.gz by itself
  if (has_suffix(path, ".zip"))
    name = name_in_zip(*name);
  else if (has_suffix(path, ".gz") && !has_suffix(path, ".hgt.gz"))
    name = "/vsigzip/" + *name;
  if (!name) return Error{path, "no heightmap in the archive; expected .hgt, .tif, .asc or .png"};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(name->c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (!dataset || dataset->GetRasterCount() == 0) {
    const bool is_hgt = has_suffix(*name, ".hgt");
    return Error{
        path,
        is_hgt
            ? "not an SRTM heightmap: expected 1201 or 3601 samples a side (2,884,802 or 25,934,402 bytes) and a name "
              "like N42E001.hgt"
            : "not a readable heightmap: expected .hgt, GeoTIFF, an ASCII grid or PNG"};
  }
  return dataset;
}

// Converts a geotransform from the outer corner of the first pixel to the centre of the first sample.
std::array<double, 6> centres(const std::array<double, 6>& corner) {
  return {corner[0] + 0.5 * corner[1] + 0.5 * corner[2], corner[1], corner[2],
          corner[3] + 0.5 * corner[4] + 0.5 * corner[5], corner[4], corner[5]};
}

void place_as_tile(const std::array<int, 3>& zxy, Raster& raster) {
  const double tile_m = 2 * kMercatorHalf_m / std::ldexp(1.0, zxy[0]);
  raster.from_grid = centres({zxy[1] * tile_m - kMercatorHalf_m, tile_m / raster.columns, 0,
                              kMercatorHalf_m - zxy[2] * tile_m, 0, -tile_m / raster.rows});
  raster.system_wkt = web_mercator_wkt();
}

void place_in(const LonLatBox& box, Raster& raster) {
  raster.from_grid = centres(
      {box.west, (box.east - box.west) / raster.columns, 0, box.north, 0, -(box.north - box.south) / raster.rows});
}

bool lies_on_earth(const Raster& raster) {
  const std::array<double, 6>& a = raster.from_grid;
  const double east = a[0] + a[1] * (raster.columns - 1), south = a[3] + a[5] * (raster.rows - 1);
  // a global raster may extend one pixel beyond the globe
  return std::abs(a[0]) <= 361 && std::abs(east) <= 361 && std::abs(a[3]) <= 91 && std::abs(south) <= 91;
}

// Locates the samples by the user's settings, else by the file.
std::optional<Error> locate_samples(GDALDataset& dataset, const RasterSpec& spec, Raster& raster) {
  if (spec.tile_zxy) {
    place_as_tile(*spec.tile_zxy, raster);
    return std::nullopt;
  }
  if (spec.bounds) {
    place_in(*spec.bounds, raster);
    return std::nullopt;
  }
  const QuietGdal quiet;
  std::array<double, 6> corner{};
  if (dataset.GetGeoTransform(corner.data()) != CE_None) {
    return Error{spec.path, "the file has no georeference; add bounds=W/S/E/N or tile=Z/X/Y"};
  }
  raster.from_grid = centres(corner);
  const OGRSpatialReference* system = dataset.GetSpatialRef();
  if (system && !system->IsLocal()) {
    raster.system_wkt = system_wkt_of(*system);
  } else if (!lies_on_earth(raster)) {
    return Error{spec.path, "the file has no reference system and its coordinates are not degrees"};
  }
  return std::nullopt;
}

// Reverses rows given from south to north, so that row 0 is the northernmost.
void put_north_first(Raster& raster) {
  if (raster.from_grid[5] <= 0) return;
  for (int row = 0; row < raster.rows / 2; ++row) {
    const auto top = raster.heights_m.begin() + static_cast<std::ptrdiff_t>(row) * raster.columns;
    const auto bottom = raster.heights_m.begin() + static_cast<std::ptrdiff_t>(raster.rows - 1 - row) * raster.columns;
    std::swap_ranges(top, top + raster.columns, bottom);
  }
  std::array<double, 6>& a = raster.from_grid;
  a = {a[0] + a[2] * (raster.rows - 1), a[1], -a[2], a[3] + a[5] * (raster.rows - 1), a[4], -a[5]};
}

void cut_to_window(const PixelWindow& window, Raster& raster) {
  std::array<double, 6>& a = raster.from_grid;
  a[0] += a[1] * window.column + a[2] * window.row;
  a[3] += a[4] * window.column + a[5] * window.row;
  for (const int step : {1, 2, 4, 5}) a[static_cast<std::size_t>(step)] *= window.stride;
  raster.columns = window.columns;
  raster.rows = window.rows;
}

// The spec with a scale that includes the unit of the file's heights. A scale or unit by the user replaces it.
RasterSpec with_unit(GDALDataset& dataset, RasterSpec spec, Raster& raster) {
  if (spec.unit_m) {
    spec.scale *= *spec.unit_m;
  } else if (spec.scale == 1 && spec.encoding.empty()) {
    raster.unit_m = height_unit_m(dataset.GetSpatialRef(), dataset.GetRasterBand(1)->GetUnitType()).value_or(1);
    spec.scale = raster.unit_m;
  }
  return spec;
}

Result<Raster> read(const RasterSpec& spec, const LonLatBox* box, double spacing_m) {
  Result<GDALDatasetUniquePtr> dataset = open(spec.path);
  if (!dataset) return dataset.error();
  Raster raster;
  raster.file_name = fs::path(spec.path).filename().string();
  raster.credit = spec.credit;
  raster.is_fitted = spec.is_fitted;
  raster.columns = (*dataset)->GetRasterXSize();
  raster.rows = (*dataset)->GetRasterYSize();
  if (const std::optional<Error> error = locate_samples(**dataset, spec, raster)) return *error;

  raster.file_box = lonlat_box_of(raster);
  PixelWindow window{0, 0, raster.columns, raster.rows};
  if (box) {
    const Result<PixelWindow> needed = window_of(raster, *box);
    if (!needed) return needed.error();
    window = *needed;
  }
  // before the file is cut: equal for all windows
  const Vec2 whole_m = window.columns > 0 ? sample_spacing_m(raster) : Vec2{};
  if (spacing_m > 0) window = thinned(window, whole_m, spacing_m);
  raster.file_spacing_m = std::min(whole_m.x, whole_m.y) * window.stride;
  cut_to_window(window, raster);
  if (raster.columns == 0) return raster;
  const RasterSpec in_metres = with_unit(**dataset, spec, raster);
  raster.code_heights_m = code_heights_m(*(*dataset)->GetRasterBand(1), in_metres);
  Result<std::vector<float>> heights_m = read_samples(**dataset, window, in_metres);
  if (!heights_m) return heights_m.error();
  raster.heights_m = std::move(*heights_m);
  put_north_first(raster);
  raster.spacing_m = sample_spacing_m(raster);
  return raster;
}

}  // namespace

Result<Raster> read_file(const RasterSpec& spec, const LonLatBox* window, double spacing_m) {
  try {
    return read(spec, window, spacing_m);
  } catch (const std::exception&) {
    return Error{spec.path, "not enough memory to hold the heightmap"};
  }
}

}  // namespace citykiln::source::gdal
