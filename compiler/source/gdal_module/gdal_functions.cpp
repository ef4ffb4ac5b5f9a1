#include "compiler/source/gdal_module/gdal_functions.h"

#include "compiler/source/gdal_module/raster_system.h"
#include "compiler/source/gdal_module/read_file.h"

const citykiln::source::GdalFunctions* citykiln_gdal() {
  namespace gdal = citykiln::source::gdal;
  static constexpr citykiln::source::GdalFunctions kFunctions = {gdal::read_file, gdal::sample_spacing_m,
                                                                 gdal::from_wgs84};
  return &kFunctions;
}
