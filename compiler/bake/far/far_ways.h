// Roads and watercourses that leave a scene: they go on as strips that fade into the land, or become narrow.
#pragma once

#include <vector>

#include "compiler/bake/far/far_land.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

/// Returns a strip for each street, railway and watercourse on the ground that crosses the edge of a scene. It goes on
/// along the ground in the direction in which the way leaves, for 350 m (service roads) to 1,600 m (motorways). It
/// stops earlier at water, at a tile, and where the slope of the land exceeds 1:6. The colour of roads fades into that
/// of the land; watercourses become narrower. One mesh for roads, one for water; either may be missing. O(roads).
std::vector<materials::MaterialMesh> far_ways(const scene::Scene& scene, const FarLand& land,
                                              const surroundings::AroundSurface& surface);

}  // namespace citykiln::bake
