// Reads heightmaps with GDAL: .hgt (also zipped), GeoTIFF, ASCII grids, pictures with given bounds, terrarium and
// mapbox tiles.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/raster.h"

namespace citykiln::source {

/// Parses "FILE,key=value,…" (see RasterSpec). Where the name of an existing file has commas, it counts as a whole.
/// Errors name an unknown key or an invalid value.
Result<RasterSpec> parse_raster_spec(std::string_view text);

/// Reads the samples of one heightmap; voids become NaN.
/// @param window     If given, only samples inside this box and a margin of 24 samples are read. A raster outside of it
///                   has no columns, no rows and no spacing.
/// @param spacing_m  Largest distance between samples that is needed: of a finer raster only every n-th sample is read.
///                   0: all samples.
///
/// Errors: a missing or unreadable file, a picture without bounds, an encoding that does not fit the bands.
Result<Raster> read_raster(const RasterSpec& spec, const LonLatBox* window, double spacing_m = 0);

/// Reads heightmaps and mends them: joins files of one grid (join_rasters.h), removes values that stand for no height
/// (codes_to_voids.h), spikes (spikes_to_voids.h) and blocks of broken samples (blocks_to_voids.h), fills voids
/// (samples without a height). The result has the order of the specs. A unit other than the metre is diagnosed
/// kHeightUnit. Parameters and errors are those of read_raster(), and heights that are not on Earth
/// (first_height_off_land()); with spacing_m, for land that is only seen from afar, these are clamped instead.
Result<std::vector<Raster>> read_heightmaps(std::span<const RasterSpec> specs, const LonLatBox* window, Report& report,
                                            double spacing_m = 0);

/// The distance of samples east and north at the middle of the raster, in metres on the ground, rounded to 2^-10 m to
/// be independent of the last bit of the CPU's cosine. For a grid turned against the meridian by more than 1 in 8, both
/// are the smaller of its two spacings. 0 if the middle is not on Earth.
Vec2 spacing_m_of(const Raster& raster);

/// Replaces a longitude x and a latitude y (WGS84 degrees) by the coordinates of the place in a raster's own system, in
/// its unit; NaN for places that cannot be converted. Not safe to call from two threads.
using ToRasterSystem = std::function<void(double& x, double& y)>;
/// Returns the transformation to a raster's system, by GDAL/PROJ; the identity if system_wkt is empty. Error: a system
/// that cannot be converted.
Result<ToRasterSystem> to_system_of(const Raster& raster);

}  // namespace citykiln::source
