// Roads and watercourses that leave a scene: they go on as strips that fade into the land, or become narrow.
#pragma once

#include <vector>

#include "compiler/bake/far/far_land.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

/// Returns a strip for each street, railway and watercourse on the ground that crosses the edge of a scene. It goes on
/// in the direction in which the road leaves, 350 m for service roads to 1,600 m for motorways, on the ground, and ends
/// early at water, at tiles and where the land rises by more than 1 in 6. Its colour fades into that of the land;
/// watercourses taper. One mesh for roads, one for water; either may be missing. O(roads).
std::vector<materials::MaterialMesh> far_ways(const scene::Scene& scene, const FarLand& land,
                                              const surroundings::AroundSurface& surface);

}  // namespace citykiln::bake
