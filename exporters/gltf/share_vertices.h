// Makes triangles share vertices that have become equal.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Replaces vertices by the first equal one of the same object run (object_runs.h), and drops those without a triangle.
/// Normals, if there are any, are equal where they are in kPackedNormalBits; all else must be equal to the last bit.
/// Triangles that have become a line or a point go; the others keep their order. Total. O(n) on average.
void share_vertices(bake::Primitive& primitive);

}  // namespace citykiln::exporters
