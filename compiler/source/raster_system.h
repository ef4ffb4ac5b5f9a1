// Reference systems of rasters, by PROJ through GDAL.
#pragma once

#include <string>

#include "compiler/source/raster.h"

class OGRSpatialReference;

namespace citykiln::source {

/// What Raster::system_wkt holds for this system: "" for longitude and latitude on WGS84.
std::string system_wkt_of(const OGRSpatialReference& system);

/// The system of Web Mercator tiles (EPSG:3857).
std::string web_mercator_wkt();

/// How far apart samples lie at the middle of the raster, east and north, metres on the ground, rounded to 2^-10 m (so
/// that it does not depend on the last bit of the CPU's cosine). Of a grid that is turned against the meridian by more
/// than one in eight, the smaller of its two spacings both ways. 0 if the middle has no place on Earth.
Vec2 spacing_m_of(const Raster& raster);

}  // namespace citykiln::source
