// Compares heightmaps where they meet, and shifts those that the user asked to fit.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"

namespace citykiln::map {

/// Returns the heightmaps in their order. Heightmaps with Raster::is_fitted (the user's offset=auto) are shifted by
/// their mean difference to one heightmap that is not fitted: the first in the given order that they meet in the
/// extent, else the first that they overlap there. Raster::shift_m states the shift, a multiple of kHeightQuantum_m.
/// All others are unchanged.
///
/// Differences are measured on 128 lines across the extent, 64 from west to east and 64 from south to north. At each
/// place the first heightmap that has a height there is used. Two heightmaps meet where this changes from one to the
/// other between two places of a line. Their heights are compared at the place that both cover; where they only touch,
/// both are extrapolated to the middle between the places.
///
/// Diagnosed: kHeightStep for each pair that meets with a step (source::step_of_m()), if neither is fitted;
/// kHeightShifted for each shift. Errors: a fitted heightmap that neither meets nor overlaps one that is not fitted; a
/// reference system that is unknown. Cost: 128 lines of at most 1,025 places, each times the heightmaps and the square
/// of those that cover it. Nothing is measured for a single heightmap that is not fitted.
/// @param extent  The compiled part of the plane, metres.
Result<std::vector<source::Raster>> fit_heightmaps(std::vector<source::Raster> rasters, const Plane& plane,
                                                   const Box2& extent, Report& report);

}  // namespace citykiln::map
