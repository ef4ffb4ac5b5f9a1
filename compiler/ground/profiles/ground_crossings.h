// Ground crossings: places where two ways on the ground cross without a common node, and the steps in the ground there.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// A place where two ways cross.
struct GroundCrossing {
  Vec2 at;
  std::uint32_t first = 0, second = 0;     ///< Indices of the ways; first < second.
  double first_at_m = 0, second_at_m = 0;  ///< Distances along them.
};

/// Returns the places where axes of ways on the ground cross. Segments that share a vertex do not cross; ways inside
/// buildings are left out. Sorted by place, then ways. O(n log n) in segments.
/// @param ways  The ways of a graph; lines that leave the ground are skipped.
std::vector<GroundCrossing> ground_crossings(std::span<const GraphWay> ways);

/// Smaller steps are not diagnosed: roads that blend hide them.
inline constexpr double kSmallStep_m = 0.5;

/// Diagnoses kStepAtCrossing for pairs of ways whose heights differ where they cross, with their largest step.
/// @param crossings  Result of ground_crossings().
/// @param z_m        Planned heights by node.
void diagnose_steps(const ProfileGraph& graph, std::span<const GroundCrossing> crossings, std::span<const double> z_m,
                    Report& report);

}  // namespace citykiln::ground
