// Smooths the heights of all stations: near the terrain's heights, with as little bending as the class requires.
//
// The plane is covered by overlapping square windows. Each window is solved independently, with all stations within
// kHalo_m, and solutions are blended in the overlaps. So the result depends on no data farther than kSmoothRadius_m in
// plan, and needs neither iteration over the whole network nor fixed points.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// The width of a window; the distance of blending on either side of its borders; the width of its halo, which is three
/// smoothing lengths of a motorway, after which a hundredth of a disturbance is left.
inline constexpr double kWindow_m = 512, kWindowBlend_m = 64, kHalo_m = 192;
inline constexpr double kSmoothRadius_m = kWindow_m + 2 * kWindowBlend_m + kHalo_m;

/// The distance from the result at which data have half the weight (Cauchy's weights).
inline constexpr double kRobustScale_m = 4;

/// Returns heights by node that minimise the sum of (z - data)² dx + l⁴ z''² dx along ways that continue each other. l
/// is the class's smoothing length, on the ground at least 3/4 of `step_m`. Weights: 1 on the ground, 1/20 off it,
/// 10,000 for pinned nodes (whose heights are fixed); outliers get less weight in two more rounds.
///
/// @param data_m  Heights by node to approximate.
/// @param step_m  The longer grid step of the terrain.
///
/// Guarantees: constant data stay; adding a constant to the data adds it to the result. O(n log n), Eigen's
/// SimplicialLDLT per window.
std::vector<double> smooth_heights(const ProfileGraph& graph, std::span<const double> data_m, double step_m);

}  // namespace citykiln::ground
