// What the heightmap says of each station: the ground without its spikes, and for what leaves the ground the line
// between the places where it comes down.
#pragma once

#include <vector>

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// A vertex of the heightmap that lies farther than this times the grid's step from the median of the 24 about it is a
/// spike, and that median is used: no road runs over a summit as steep as that.
inline constexpr double kSpike = 0.75;
/// On fine grids trees and houses are no spikes.
inline constexpr double kLeastSpike_m = 16;

/// How far along bridges or tunnels their ends are looked for.
inline constexpr double kSpanEndRadius_m = 4096;

/// From the ground to a tunnel's road: soil, vault and clear height.
inline constexpr double kTunnelCover_m = 7, kPathTunnelCover_m = 4.5;

/// The heightmap's height without spikes. Reach: three of its steps. O(1).
double height_without_spikes_m(const map::Heightfield& heights, Vec2 p);

/// By node. Off the ground: heights of the nodes on the ground within kSpanEndRadius_m along what is off it, weighted
/// by the inverse of the distance (between two ends: the straight line). Where there is none a bridge lies on the
/// ground, and a tunnel stays kTunnelCover_m under it, no steeper than its limit.
std::vector<double> initial_heights(const ProfileGraph& graph, const map::Heightfield& heights);

/// Gives nodes off the ground the heights between those on it, of heights by node.
void interpolate_spans(const ProfileGraph& graph, std::vector<double>& z_m);

}  // namespace citykiln::ground
