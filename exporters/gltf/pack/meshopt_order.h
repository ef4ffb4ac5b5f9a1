// Orders triangles so that vertices differ little from their predecessors: meshopt stores these differences.
#pragma once

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// Orders the triangles of a mesh and rotates their corners, which changes no shape:
///
/// 1. triangles that share vertices follow each other (meshopt_optimizeVertexCacheStrip);
/// 2. connected parts of one feature are sorted by colour, then normal, so faces of one wall and direction are
/// together;
/// 3. the first triangle of a part begins at the corner from which positions change in the fewest bytes.
///
/// Then sorts vertices by their first use and removes unused ones. On buildings of Monaco at 0.1 m this saves 7 % of a
/// tile. O(n log n).
void order_for_meshopt(MeshArrays& mesh);

}  // namespace citykiln::exporters
