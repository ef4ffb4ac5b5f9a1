// Measures how far a river's fitted heights are from the terrain over longer distances than noise explains.
#pragma once

#include <span>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// The greatest depth below the terrain, or height above it, of watercourses over more than kSustained grid steps:
/// narrower than 2 m (ditches), narrower than 8 m (streams), others (rivers). Twice the height of banks that stand
/// without a wall (3, 5 and 8 m), as the terrain may be wrong by the same amount.
inline constexpr double kMaxDitchDepth_m = 6, kMaxStreamDepth_m = 10, kMaxRiverDepth_m = 16;
/// Length in grid steps of the terrain. Shorter stretches are trees, bridges and broken samples, which a river cuts
/// through.
inline constexpr double kSustained = 2;
/// The greatest depth below the land on the line to which a valley's floor beside it counts. Banks are graded within
/// 16 m, so that a bank of this height is not steeper than 3 : 4.
inline constexpr double kMaxAside_m = 12;

/// Returns the largest usual depth, one of the constants above, of a watercourse of this width.
double max_depth_m(double width_m);

/// Returns how far a height is above the land of a node (> 0), or below the lowest land across the line there (< 0).
/// @param aside_m  The greatest depth below the land on the line to which the lowest land counts.
double above_land_m(const RiverNode& node, double height_m, double aside_m);

/// Returns the greatest distance d for which all stations of a stretch longer than run_m are at least d below, or all
/// at least d above, the terrain within the line's lateral error; 0 if there is no such stretch. Stations in standing
/// water and off the terrain end a stretch.
/// @param heights_m  Per stop of the line.
/// @param run_m      Shortest length of a stretch.
/// @param aside_m    The limit of above_land_m().
/// O(stations · stations within run_m).
double sustained_depth_m(const RiverNetwork& network, const RiverLine& line, std::span<const double> heights_m,
                         double run_m, double aside_m = kMaxAside_m);

}  // namespace citykiln::ground
