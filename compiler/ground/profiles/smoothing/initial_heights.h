// Initial heights of stations, the places along roads and rails at which heights are decided: the filtered terrain on
// the ground; on bridges and in tunnels a line between their ends.
#pragma once

#include <vector>

#include "compiler/ground/landforms/landform_index.h"
#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// A sample of the terrain is filtered as a steep summit if it differs from the median of the 24 samples about it by
/// more than this times their distance. The median replaces it, since roads do not run over steep summits. Broken
/// samples ("spikes") have been removed before, by source/spikes_to_voids.
inline constexpr double kMaxSummitSlope = 0.75;
/// Smaller differences are never filtered. On fine grids they are trees and houses.
inline constexpr double kMinSummit_m = 16;

/// The largest distance along bridges or tunnels at which their ends are searched.
inline constexpr double kSpanEndRadius_m = 4096;

/// The smallest height of the ground above a tunnel's road or path: soil, vault and clear height.
inline constexpr double kTunnelCover_m = 7, kPathTunnelCover_m = 4.5;

/// Returns the terrain's height at p, moved as far as steep summits about it are replaced. Depends on samples within
/// three of their steps. O(1).
double filtered_height_m(const map::Heightfield& heights, Vec2 p);

/// Returns heights by node. A node of a bridge or tunnel has the mean of the heights of the ground nodes within
/// kSpanEndRadius_m along bridges or tunnels, weighted by inverse distance; between two ends this is the straight line.
/// Without such nodes a bridge lies on the ground and a tunnel kTunnelCover_m below it, no steeper than its limit.
/// Ground nodes lie on landforms.
std::vector<double> initial_heights(const ProfileGraph& graph, const map::Heightfield& heights,
                                    const LandformIndex& landforms = {});

/// Sets the heights of nodes off the ground from those of ground nodes, as initial_heights() does.
void interpolate_spans(const ProfileGraph& graph, std::vector<double>& z_m);

}  // namespace citykiln::ground
