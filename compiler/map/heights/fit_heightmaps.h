// Compares heightmaps where they meet, and shifts those that the user asked to fit.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"

namespace citykiln::map {

/// Returns the heightmaps. Each with Raster::is_fitted is shifted by its mean difference to one that is not fitted: the
/// first in the given order that it meets in the extent, else the first that it overlaps there.
///
/// The first heightmap with a height at a place is used there. Two meet where it changes along one of 128 lines across
/// the extent; if neither covers both sides, heights are extrapolated. Diagnosed: kHeightStep for each pair that meets
/// with a step (source::step_of_m()), if neither is fitted; kHeightShifted for each shift. Errors: a fitted heightmap
/// without such a partner; a reference system that is unknown. Cost: 128 lines of at most 1,025 places, times the
/// heightmaps.
Result<std::vector<source::Raster>> fit_heightmaps(std::vector<source::Raster> rasters, const Plane& plane,
                                                   const Box2& extent, Report& report);

}  // namespace citykiln::map
