// Compares heightmaps where they meet, and shifts those that the user asked to fit.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"

namespace citykiln::map {

/// Returns the heightmaps; those with Raster::is_fitted are shifted by the mean difference to another one that they
/// meet in the extent, or that covers the same places.
///
/// Heightmaps meet where, along lines across the extent, the first that covers one place is not the first that covers
/// the next. Heights are extrapolated across the border. Steps between two datums (source::step_of_m()) are diagnosed
/// kHeightStep once a pair, shifts kHeightShifted. Errors: a fitted heightmap that meets no other in the extent; a
/// reference system that is unknown. Cost: 128 lines of up to 1024 places, if there are two heightmaps or more.
Result<std::vector<source::Raster>> fit_heightmaps(std::vector<source::Raster> rasters, const Plane& plane,
                                                   const Box2& extent, Report& report);

}  // namespace citykiln::map
