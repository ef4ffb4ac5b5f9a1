// Skirts: vertical strips below the ground along a tile's border. They close the gaps between neighbouring tiles of
// different levels, whose borders differ by up to their tolerances.
//
//     finer ▔▔▔▔▔▔▔╲            seen from the coarser tile, the finer one's skirt fills the
//                  ┆▁▁▁ coarser  gap; where the coarser one is higher, its own does
//                  ┆
#pragma once

#include <set>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// The depth of a skirt, in tolerances of its tile. It covers the errors of both tiles if the coarser one has at most
/// five times the tolerance, as in the default levels.
inline constexpr double kSkirtDepthTolerances = 6;

/// Adds outward-facing vertical faces below every edge of the surface that lies in the tile's border. Their vertices
/// repeat the normals, tints and uvs of the vertices above, so that they look like the ground beside them. Skirts are
/// not part of the ground's certified error. O(triangles).
///
/// @param surface  Triangles counter-clockwise seen from above, in the same frame as `tile`.
/// @param tile     The tile's box in plan, plane metres. An edge is in the border only if its coordinates equal the
///                 box's.
/// @param depth_m  >= 0; rounded to kQuantum_m.
void add_skirt(materials::MaterialMesh& surface, const Box2& tile, double depth_m);

/// Adds such faces below the edges of the surface on whose other side a face was removed.
/// @param removed  The edges of removed faces (remove_beyond_clip()): an edge of the surface is there reversed.
void add_skirt(materials::MaterialMesh& surface, const std::set<std::pair<Vec3, Vec3>>& removed, double depth_m);

}  // namespace citykiln::bake
