// Diagnoses of planned heights: lines over their grade limit, and tunnels far below the line between their mouths.
#pragma once

#include <span>

#include "compiler/contract/report.h"
#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// Diagnoses kTooSteep and kTunnelLowered for the lines whose heights a graph decides: of Lines::kGraded not the
/// bridges and tunnels of paths, whose heights are only first guesses there; of Lines::kPaths these, not paths on the
/// ground.
///
/// @param lines_m  Heights by node on the terrain, off the ground on the line between the ends.
/// @param z_m      Heights by node as planned.
void diagnose_profiles(const ProfileGraph& graph, std::span<const double> lines_m, std::span<const double> z_m,
                       Report& report);

}  // namespace citykiln::ground
