// Grade limits, exactly and locally: between the highest heights below and the lowest above that keep them.
//
//          ╱╲        S          U(x) = min over y of S(y) + cost(x, y)     L(x) = max over y of S(y) - cost(x, y)
//        ╱----╲     (U+L)/2     cost: the sum of limit · length on the way from x to y. Both keep the limits, and so
//     __╱      ╲__              does what lies half-way between.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profile_graph.h"

namespace citykiln::ground {

/// A place that is too steep is felt this far along the network: 50 m of height at 10 %.
inline constexpr double kGradeReach_m = 512;
/// Nothing is cut or filled by more than this for a grade's sake.
inline constexpr double kMostEarth_m = 12;

/// U of the figure, by node: the highest heights not above those given that keep the limits. Reach: kGradeReach_m.
std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m);

/// By node. Pinned nodes stay. Guarantees: legs keep their limits, unless a place is too steep for longer than
/// kGradeReach_m or asks for more than kMostEarth_m; heights that keep them stay as they are. Total. Cost: the legs
/// within reach of those too steep.
std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m);

}  // namespace citykiln::ground
