// Limits grades, exactly and locally, by the mean of the highest admissible heights below and the lowest above.
//
//          ╱╲        S          U(x) = min over y of S(y) + cost(y, x)     L(x) = max over y of S(y) - cost(y, x)
//        ╱----╲     (U+L)/2     cost: the sum of limit · length on the way from y to x. Both keep the limits, and so
//     __╱      ╲__              does what lies half-way between.
//
// The nodes of a junction plane move together: between them the cost is the difference of their heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// Influence radius in plan of a place that is too steep: 50 m of height at 10 %.
inline constexpr double kGradeInfluence_m = 512;
/// No grade is limited by more than half of this of cut or fill.
inline constexpr double kMaxEarthwork_m = 24;

/// The influence of a place that is too steep: its radius in plan and its largest effect, which falls linearly to 0 at
/// the radius, so heights stay continuous.
struct GradeInfluence {
  double radius_m = kGradeInfluence_m, max_m = kMaxEarthwork_m;
};

/// Returns U of the figure by node: the greatest heights not above those given that keep the limits within the
/// influence.
std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m, GradeInfluence influence);

/// Returns heights by node with grades limited. Pinned nodes stay and limit what is near.
///
/// @param steepness  By node: factor on the limit of legs to it, beside the graph's own scale; empty: 1.
///
/// Guarantees: legs keep their limits and junction planes stay planes, except where a place needs more than
/// GradeInfluence; heights within the limits stay. Total. Cost: the legs within the influence of those that are too
/// steep.
std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m,
                                 std::span<const double> steepness = {});

}  // namespace citykiln::ground
