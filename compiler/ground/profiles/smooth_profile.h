// Smooth heights for all stations at once: near the heightmap's, bending as little as their class asks for.
//
// The network is covered by squares that overlap. Each is solved for itself, with all that lies within kHalo_m of it;
// where squares overlap their solutions are blended. So nothing depends on what is farther than kSmoothRadius_m, in
// plan; nothing is iterated over the whole; and a network of any shape needs no anchors.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// Squares are this wide, blended over kWindowBlend_m on either side of their borders, and see kHalo_m beyond: three
/// smoothing lengths of a motorway, where what is left of a disturbance is a hundredth.
inline constexpr double kWindow_m = 512, kWindowBlend_m = 64, kHalo_m = 192;
inline constexpr double kSmoothRadius_m = kWindow_m + 2 * kWindowBlend_m + kHalo_m;

/// Data that miss the line by this count half (Cauchy's weights).
inline constexpr double kRobustScale_m = 4;

/// By node: minimises the sum of (z - data)^2 dx + l^4 z''^2 dx, l the class' smoothing length or three
/// quarters of the heightmap's longer step `step_m`, whichever is more, over ways that go on
/// into each other; data off the ground count a twentieth, pinned ones as much as ten thousand; data are weighed again
/// twice by how far they miss.
///
/// Guarantees: equal data stay what they are; a constant more in the data is that constant more; reach as above. Total.
/// O(n log n), Eigen's SimplicialLDLT for each square.
std::vector<double> smooth_heights(const ProfileGraph& graph, std::span<const double> data_m, double step_m);

}  // namespace citykiln::ground
