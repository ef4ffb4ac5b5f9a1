// The functions of the GDAL module, which is loaded when a heightmap is read: GDAL brings about a hundred libraries,
// which would add 0.08 s to every start.
#pragma once

#include "compiler/contract/result.h"
#include "compiler/source/raster.h"
#include "compiler/source/read_raster.h"

namespace citykiln::source {

/// Program and module are built together, so C++ types pass between them. Contracts and
/// errors of the functions: read_raster.h.
struct GdalFunctions {
  Result<Raster> (*read_raster)(const RasterSpec& spec, const LonLatBox* window, double spacing_m);
  Vec2 (*spacing_m_of)(const Raster& raster);
  Result<ToRasterSystem> (*to_system_of)(const Raster& raster);
};

}  // namespace citykiln::source

/// The table of functions; never null.
extern "C" const citykiln::source::GdalFunctions* citykiln_gdal();
