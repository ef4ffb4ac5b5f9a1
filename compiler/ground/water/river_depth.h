// How deep below the terrain, or how high above it, a river's fitted heights lie for longer than noise explains.
#pragma once

#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// Greatest depth below the terrain, and height above it, that watercourses may have over more than kSustained of its
/// grid steps, by width: below 2 m (ditches), below 8 m (streams), others (rivers). Twice as deep as banks stand
/// without a wall (3, 5 and 8 m): the terrain may be wrong by as much again.
inline constexpr double kMaxDitchDepth_m = 6, kMaxStreamDepth_m = 10, kMaxRiverDepth_m = 16;
/// Shorter stretches are trees, bridges and broken samples of the terrain, which a river cuts through.
inline constexpr double kSustained = 2;

/// Returns the greatest depth or height by the width of a watercourse.
double max_depth_m(double width_m);

/// Returns the greatest distance from the terrain that all stations of some stretch longer than run_m have on the same
/// side; 0 without such a stretch. Stations in standing water and off the terrain end a stretch. O(stations times those
/// within run_m).
double sustained_depth_m(const RiverNetwork& network, const RiverLine& line, const RiverHeights& heights, double run_m);

}  // namespace citykiln::ground
