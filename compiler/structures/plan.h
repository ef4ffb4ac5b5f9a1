// Stage 5: heights of bridges and tunnels.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Structures {
  std::vector<Span> bridges;  ///< Sorted by id.
  std::vector<Span> tunnels;  ///< Sorted by id; in the manifest, not meshed (diagnosed kTunnelNotMeshed).
};

/// Bridges run between the heights of their ends: nodes that a bridge shares with the ground take the ground's height;
/// nodes only bridges share lie on the line between those, and rise towards the clearance of their layer as far as
/// kBridgeGrade allows. Ledger "structures/bridge", "structures/tunnel". Total. Reach: the connected bridges of one
/// place.
Structures plan(const map::Features& features, const map::Heightfield& heights, Report& report);

}  // namespace citykiln::structures
