// Ground crossings: places where two ways on the ground cross without a common node. Their heights should be equal
// there, since the ground has one height at each place.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// A place where two ways cross.
struct GroundCrossing {
  Vec2 at;                                 ///< Plane metres.
  std::uint32_t first = 0, second = 0;     ///< Indices of the ways; first < second.
  double first_at_m = 0, second_at_m = 0;  ///< Distances along them, from their first points.
};

/// Returns the places where axes of ways on the ground cross, sorted by place, then ways. Segments that share a vertex
/// do not cross. Bridges, tunnels and indoor ways are skipped. O(n log n) in segments.
/// @param ways  ProfileGraph::ways.
std::vector<GroundCrossing> ground_crossings(std::span<const GraphWay> ways);

/// The largest difference in height that is not diagnosed: the ground between the roads hides it.
inline constexpr double kSmallStep_m = 0.5;

/// Diagnoses kStepAtCrossing once for each pair of ways whose heights differ by more than kSmallStep_m where they
/// cross, with their largest difference.
/// @param crossings  Result of ground_crossings().
/// @param z_m        Planned height of each node of the graph.
void diagnose_steps(const ProfileGraph& graph, std::span<const GroundCrossing> crossings, std::span<const double> z_m,
                    Report& report);

}  // namespace citykiln::ground
