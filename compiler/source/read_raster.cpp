#include "compiler/source/read_raster.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "compiler/contract/system/load_module.h"
#include "compiler/source/gdal_module/gdal_functions.h"
#include "compiler/source/voids/blocks_to_voids.h"
#include "compiler/source/voids/codes_to_voids.h"
#include "compiler/source/voids/fill_gaps.h"
#include "compiler/source/voids/join_rasters.h"
#include "compiler/source/voids/spikes_to_voids.h"

namespace citykiln::source {
namespace {

namespace fs = std::filesystem;

Result<const GdalFunctions*> load_gdal() {
  const Result<void*> function = load_function("citykiln_gdal.so", "citykiln_gdal");
  if (!function) return function.error();
  return reinterpret_cast<decltype(&citykiln_gdal)>(*function)();
}

std::optional<Error> problem_of_file(const std::string& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) return Error{path, "no such file"};
  if (!fs::is_regular_file(path, failure)) return Error{path, "not a file"};
  if (fs::file_size(path, failure) == 0) return Error{path, "the file is empty"};
  return std::nullopt;
}

// Replaces heights that are not on Earth by the nearest that are. Voids stay.
void clamp_to_earth(Raster& raster) {
  for (float& height_m : raster.heights_m)
    height_m = std::clamp(height_m, static_cast<float>(kLowestLand_m), static_cast<float>(kHighestLand_m));
}

}  // namespace

Result<Raster> read_raster(const RasterSpec& spec, const LonLatBox* window, double spacing_m) {
  if (const std::optional<Error> problem = problem_of_file(spec.path)) return *problem;
  const Result<const GdalFunctions*> gdal = load_gdal();
  if (!gdal) return gdal.error();
  return (*gdal)->read_raster(spec, window, spacing_m);
}

Result<std::vector<Raster>> read_heightmaps(std::span<const RasterSpec> specs, const LonLatBox* window, Report& report,
                                            double spacing_m) {
  std::vector<Raster> rasters;
  for (const RasterSpec& spec : specs) {
    Result<Raster> raster = read_raster(spec, window, spacing_m);
    if (!raster) return raster.error();
    if (raster->unit_m != 1) report.add(Code::kHeightUnit, OsmId{}, raster->unit_m);
    rasters.push_back(std::move(*raster));
  }
  rasters = join_rasters(std::move(rasters));
  for (Raster& raster : rasters)
    raster = blocks_to_voids(spikes_to_voids(codes_to_voids(std::move(raster), report), report), report);
  for (Raster& raster : rasters) {
    if (spacing_m > 0) clamp_to_earth(raster);
    if (const std::optional<Error> error = first_height_off_land(raster)) return *error;
    raster = fill_voids(std::move(raster), report);
  }
  return rasters;
}

Vec2 spacing_m_of(const Raster& raster) {
  const Result<const GdalFunctions*> gdal = load_gdal();
  return gdal ? (*gdal)->spacing_m_of(raster) : Vec2{};
}

Result<ToRasterSystem> to_system_of(const Raster& raster) {
  if (raster.system_wkt.empty()) return ToRasterSystem([](double&, double&) {});
  const Result<const GdalFunctions*> gdal = load_gdal();
  if (!gdal) return gdal.error();
  return (*gdal)->to_system_of(raster);
}

}  // namespace citykiln::source
