// Skirts close the gaps between neighbouring tiles of different levels, whose borders differ by up to their tolerances:
// vertical strips that hang down from the ground along the tile's border.
//
//     finer ▔▔▔▔▔▔▔╲            seen from the coarser tile, the finer one's skirt fills the
//                  ┆▁▁▁ coarser  gap; where the coarser one is higher, its own does
//                  ┆
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// Depth of a skirt in tolerances: the sum of both tiles' errors where the next level is at most five times coarser, as
/// in the default ladder.
inline constexpr double kSkirtDepthTolerances = 6;

/// Adds vertical faces, facing outwards, below every edge that lies in the border of the tile. Their vertices have the
/// normals, tints and uvs of those above, so that they look like the ground beside them. They lie below the ground and
/// are not part of its certified error. O(triangles).
void add_skirt(materials::MaterialMesh& surface, const Box2& tile, double depth_m);

}  // namespace citykiln::bake
