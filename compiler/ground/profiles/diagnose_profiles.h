// Diagnoses planned heights: lines steeper than their grade limit, and tunnels far below the line between their mouths.
#pragma once

#include <span>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// Diagnoses kTooSteep and kTunnelLowered for the lines whose heights the graph decides. In a graph of Lines::kGraded
/// these are all lines except bridges and tunnels of paths, whose heights are preliminary there; in a graph of
/// Lines::kPaths these are the bridges and tunnels of paths.
///
/// @param lines_m  Initial heights by node: the terrain's; on a bridge or in a tunnel, those of the line between
///                 its ends.
/// @param z_m      Planned heights by node.
void diagnose_profiles(const ProfileGraph& graph, std::span<const double> lines_m, std::span<const double> z_m,
                       Report& report);

}  // namespace citykiln::ground
