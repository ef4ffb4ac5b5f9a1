// Makes the triangles of leaves: polygons and instances.
#pragma once

#include "lsystems/mesh/tubes.h"

namespace citykiln::lsystems {

/// Adds a skeleton's polygons and, if options.instances, its instances to out.leaf, as specified by mesh_plant().
/// Polygons are triangulated by ear clipping in their mean plane (Newell's method); their orientation gives the normal.
/// Leaves without area, or no larger than the tolerance, are left out and counted in out.left_out.
void mesh_leaves(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& out);

/// Triangulates a ring of n points, n >= 3, into n - 2 triangles: by ear clipping; as a fan if it is convex or has more
/// than kMostClipped points. Where no ear is found, the rest of the ring becomes a fan. Rings may intersect themselves.
/// At worst O(n³).
std::vector<Triangle> triangulate_ring(std::span<const Vec2> ring);

}  // namespace citykiln::lsystems
