// What trees are put together of. Metres for a tree 1 m tall, z up, foot of the trunk at the origin; all positions on
// the 2^-10 m grid.
#pragma once

#include <cstdint>

#include "compiler/geometry/mesh.h"

namespace citykiln::plants {

/// A lump of leaves: an ellipsoid of 20 triangles, or of 80 when `is_fine`, dented by chance; closed. The coarse one's
/// corners are the fine one's too. Normals lie between the ellipsoid's own and the direction away from `heart`, so that
/// light takes all lumps of a crown as one mass.
/// @param dent    Deepest dent, as a share of the radius.
/// @param number  Which dents.
void add_lump(Mesh& mesh, Vec3 centre, Vec3 radii, double dent, bool is_fine, Vec3 heart, std::uint32_t number);

/// A skirt of branches: a cone with a rim that reaches out unevenly and droops, and a shallow hollow from below;
/// closed.
void add_skirt(Mesh& mesh, int sides, double rim_z, double tip_z, double radius, std::uint32_t number);

/// A trunk: the mantle of a cone stump, open at both ends, which lie in the ground and in the crown.
void add_trunk(Mesh& mesh, int sides, double bottom_z, double top_z, double bottom_radius, double top_radius);

}  // namespace citykiln::plants
