// Makes triangles share vertices that have become equal.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Replaces vertices by the first equal one of the same feature run (object_runs.h), and drops unused ones. Normals
/// count as equal if they are equal after rounding to kPackedNormalBits; all other attributes must be equal to the last
/// bit. Drops triangles that then use a vertex twice, but none if that would drop all; the others keep their order.
/// Accepts any primitive. O(n) on average.
void share_vertices(bake::Primitive& primitive);

}  // namespace citykiln::exporters
