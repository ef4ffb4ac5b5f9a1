// Neighbouring tiles at different levels do not have the same border: each is off by up to its own tolerance. A skirt
// hangs down from the ground along the tile's border and closes the gap.
//
//     finer ▔▔▔▔▔▔▔╲            seen from the coarser tile, the finer one's skirt fills what would be
//                  ┆▁▁▁ coarser  a crack; where the coarser one is higher, its own does
//                  ┆
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// How deep a skirt hangs, in tolerances: both tiles' errors, if none is more than five times coarser than the next, as
/// in the default ladder.
inline constexpr double kSkirtDepthTolerances = 6;

/// Adds upright faces, outwards, below every edge that lies in the border of the tile. Their vertices have the normals,
/// tints and places of those above them, so they look like the ground beside them. They are no part of what is
/// certified: they lie below the ground. O(triangles).
void add_skirt(materials::MaterialMesh& dressed, const Box2& tile, double depth_m);

}  // namespace citykiln::bake
