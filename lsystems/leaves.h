// Leaves: polygons and instances as triangles.
#pragma once

#include "lsystems/tubes.h"

namespace citykiln::lsystems {

/// Adds a skeleton's polygons and, if asked, instances. Polygons are cut into ears in their mean plane (Newell's);
/// which way round they go says which side is up. What has no area, or no more extent than the tolerance, is left out.
/// As in mesh_plant.
void mesh_leaves(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& out);

/// Triangles of a ring, by its points' places: ears, or a fan where no ear is found or the ring is too long. One fewer
/// than two less than points. Total: rings may cross themselves.
std::vector<Triangle> ears_of(std::span<const Vec2> ring);

}  // namespace citykiln::lsystems
