// Drops bridges and tunnels that do not matter to the extent.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/structures/plan.h"

namespace citykiln::structures {

/// Returns the bridges and tunnels whose road, or the ground that it grades, may lie in the extent. Spans that cross
/// the extent's border stay whole: baking clips their meshes. Ledger "extent/bridge", "extent/tunnel"; dropped:
/// kOutsideBounds. O(points).
Structures within_extent(Structures structures, const Box2& extent, Report& report);

}  // namespace citykiln::structures
