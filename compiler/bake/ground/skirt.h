// Skirts: vertical strips below the ground along a tile's border. They close the gaps between neighbouring tiles of
// different levels, whose borders differ by up to their tolerances.
//
//     finer ▔▔▔▔▔▔▔╲            seen from the coarser tile, the finer one's skirt fills the
//                  ┆▁▁▁ coarser  gap; where the coarser one is higher, its own does
//                  ┆
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// The depth of a skirt in tolerances: the sum of both tiles' errors if the next level is at most five times coarser,
/// as in the default levels.
inline constexpr double kSkirtDepthTolerances = 6;

/// Adds vertical faces, facing outwards, below every edge in the border of the tile. Their vertices have the normals,
/// tints and uvs of the vertices above, so that they look like the ground beside them. They are not part of the
/// ground's certified error. O(triangles).
void add_skirt(materials::MaterialMesh& surface, const Box2& tile, double depth_m);

}  // namespace citykiln::bake
