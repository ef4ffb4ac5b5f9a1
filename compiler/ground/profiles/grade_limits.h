// Grade limits, exactly and locally: between the highest heights below and the lowest above that keep them.
//
//          ╱╲        S          U(x) = min over y of S(y) + cost(y, x)     L(x) = max over y of S(y) - cost(y, x)
//        ╱----╲     (U+L)/2     cost: the sum of limit · length on the way from y to x. Both keep the limits, and so
//     __╱      ╲__              does what lies half-way between.
//
// JunctionPlanes of junctions move up or down as one: between their nodes the cost is the difference of their heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// A place that is too steep is felt this far, in plan: 50 m of height at 10 %.
inline constexpr double kGradeInfluence_m = 512;
/// Nothing is cut or filled by more than half of this for a grade's sake.
inline constexpr double kMaxEarthwork_m = 24;

/// How far a place that is too steep is felt, in plan, and by how much at most; that fades towards the reach, so that
/// nothing breaks off there.
struct GradeInfluence {
  double reach_m = kGradeInfluence_m, most_m = kMaxEarthwork_m;
};

/// U of the figure, by node: the highest heights not above those given that keep the limits, as far as the reach lets
/// them.
std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m, GradeInfluence reach);

/// By node. Pinned nodes stay, and hold what is near.
///
/// @param steepness  By node, beside the graph's own scale: legs to it may be so many times as steep; empty: none more.
///
/// Guarantees: legs keep their limits, plates stay as plane as they are, unless a place asks for more than
/// GradeInfluence leaves it; heights that keep the limits stay. Total. Cost: the legs within reach of those that are
/// too steep.
std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m,
                                 std::span<const double> steepness = {});

}  // namespace citykiln::ground
