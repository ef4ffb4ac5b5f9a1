// Limits grades. Each height becomes the mean of two heights: the highest that keeps the limits and lies below the
// given ones, and the lowest that keeps the limits and lies above them.
//
//          ╱╲        S          U(x) = min over y of S(y) + cost(y, x)     L(x) = max over y of S(y) - cost(y, x)
//        ╱----╲     (U+L)/2     cost: the sum of limit · length on the way from y to x. Both keep the limits, and so
//     __╱      ╲__              does their mean.
//
// The nodes of a junction plane move together: between them the cost is the difference of their heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// The influence radius in plan of a place that is too steep: 50 m of height at 10 %.
inline constexpr double kGradeInfluence_m = 512;
/// Twice the largest cut or fill by which a grade is limited.
inline constexpr double kMaxEarthwork_m = 24;

/// The influence of a place that is too steep: its radius in plan, and its largest effect on heights, which decreases
/// linearly to 0 at the radius, so that heights stay continuous.
struct GradeInfluence {
  double radius_m = kGradeInfluence_m, max_m = kMaxEarthwork_m;
};

/// Returns for each node U of the figure: the greatest heights that keep the limits and are not above the given ones.
/// @param influence  Limits the distance and the height by which one place changes others.
std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m, GradeInfluence influence);

/// Returns heights by node with limited grades. Pinned nodes stay, so they limit their neighbourhood.
///
/// @param steepness  For each node a factor on the limits of legs (edges) that lead to it; empty: 1. The graph's own
///                   limit_scale applies, too.
///
/// Guarantees: legs keep their limits and junction planes stay planes, unless that needs more than GradeInfluence;
/// heights within the limits stay. Cannot fail. Cost: the legs within the influence of legs that are too steep.
std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m,
                                 std::span<const double> steepness = {});

}  // namespace citykiln::ground
