// Reference systems of rasters, with GDAL and PROJ.
#pragma once

#include <optional>
#include <string>

#include "compiler/source/read_raster.h"

class OGRSpatialReference;

namespace citykiln::source::gdal {

/// Returns the value of Raster::system_wkt (well-known text) of the horizontal part of a system; "" for longitude and
/// latitude on WGS84.
std::string system_wkt_of(const OGRSpatialReference& system);

/// Returns the unit of heights in metres: that of a band ("ft"), else that of the system's vertical part; nothing where
/// neither is known.
/// @param system  May be null.
std::optional<double> height_unit_m(const OGRSpatialReference* system, const std::string& band_unit);

/// The system of Web Mercator tiles (EPSG:3857).
std::string web_mercator_wkt();

/// Returns the distances between samples east and north at the middle of a raster, in metres on the ground, rounded to
/// 2^-10 m; 0 if the middle is not on Earth. It is spacing_m_of() of read_raster.h, which says more.
Vec2 sample_spacing_m(const Raster& raster);

/// Returns a function that replaces a longitude and a latitude (WGS84 degrees) by coordinates in the raster's own
/// system, or by NaN. It is to_system_of() of read_raster.h. The function must not be called from two threads at once.
/// Error: a system that cannot be converted.
Result<ToRasterSystem> from_wgs84(const Raster& raster);

/// The box of all samples in longitude and latitude, in degrees, from nine of them; zeros if no place can be converted.
LonLatBox lonlat_box_of(const Raster& raster);

}  // namespace citykiln::source::gdal
