// Resamples heightmaps into one heightfield.
#pragma once

#include <span>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"

namespace citykiln::map {

/// Returns one field over the extent and one step of its samples beyond. Without rasters it is flat at 0.
///
/// The steps of its samples, east and north, are the largest multiples of kStepUnit_m not above the finest sample
/// distance of a raster with samples in that direction, at least 1 m and at most kCell_m. In the middle of the extent
/// they lie on samples of the first raster that covers it; farther away, where degrees and metres diverge, they lie
/// between samples, where heights are interpolated bilinearly. Steps above 24 m are divided (smooth_land.h).
///
/// @param rasters  Without voids (source::fill_voids()). At each place the first raster that covers it counts. Places
///                 that no raster covers get the nearest height (source::fill_uncovered()), diagnosed kNoHeight with
///                 their share.
/// @param extent   Plane metres, not empty.
///
/// Errors: no raster covers any vertex, or a raster's reference system is unknown.
Result<Heightfield> resample(std::span<const source::Raster> rasters, const Plane& plane, const Box2& extent,
                             Report& report);

}  // namespace citykiln::map
