// Drops bridges and tunnels outside the extent (the box that is compiled).
#pragma once

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/box.h"
#include "compiler/structures/plan.h"

namespace citykiln::structures {

/// Returns the bridges and tunnels whose road, or the ground that the road grades, may lie in the extent. Spans that
/// cross the extent's border stay whole: their meshes are clipped when tiles are baked. Ledger "extent/bridge",
/// "extent/tunnel"; dropped: kOutsideBounds. O(points).
Structures within_extent(Structures structures, const Box2& extent, Report& report);

}  // namespace citykiln::structures
