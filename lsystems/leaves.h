// Makes the triangles of leaves: polygons and instances.
#pragma once

#include "lsystems/tubes.h"

namespace citykiln::lsystems {

/// Adds a skeleton's polygons and, if options.instances, its instances to out.leaf, as specified by mesh_plant().
/// Polygons are triangulated by ear clipping in their mean plane (Newell's method); their orientation gives the normal.
/// Leaves without area, or no larger than the tolerance, are left out and counted in out.left_out.
void mesh_leaves(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& out);

/// Triangulates a ring into two triangles fewer than points: by ear clipping, or as a fan if no ear is found or the
/// ring has more than kMostClipped points. Rings may intersect themselves.
std::vector<Triangle> ears_of(std::span<const Vec2> ring);

}  // namespace citykiln::lsystems
