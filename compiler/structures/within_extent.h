// Leaves out bridges and tunnels that do not reach the extent.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/structures/plan.h"

namespace citykiln::structures {

/// Returns the bridges and tunnels that may be seen in the extent or grade its ground. Those that cross its border stay
/// whole: baking clips their meshes. Ledger "extent/bridge", "extent/tunnel"; dropped: kOutsideBounds. O(points).
Structures within_extent(Structures structures, const Box2& extent, Report& report);

}  // namespace citykiln::structures
