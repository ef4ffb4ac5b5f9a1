// Reference systems of rasters, with GDAL and PROJ.
#pragma once

#include <string>

#include "compiler/source/raster.h"

class OGRSpatialReference;

namespace citykiln::source {

/// The value of Raster::system_wkt for a system; "" for longitude and latitude on WGS84.
std::string system_wkt_of(const OGRSpatialReference& system);

/// The system of Web Mercator tiles (EPSG:3857).
std::string web_mercator_wkt();

/// The distance of samples east and north at the middle of the raster, in metres on the ground, rounded to 2^-10 m to
/// be independent of the last bit of the CPU's cosine. For a grid turned against the meridian by more than 1 in 8, both
/// are the smaller of its two spacings. 0 if the middle is not on Earth.
Vec2 spacing_m_of(const Raster& raster);

/// The box of all samples in longitude and latitude, in degrees, from nine of them; zeros if no place can be converted.
LonLatBox lonlat_box_of(const Raster& raster);

}  // namespace citykiln::source
