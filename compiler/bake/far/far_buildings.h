// Blocks of roofs around a scene: its buildings along the edge, mirrored outwards as boxes with roofs.
#pragma once

#include <vector>

#include "compiler/bake/far/patchwork.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

/// The largest number of mirrored buildings, of 8 to 10 triangles each: those nearest to the edge are kept.
inline constexpr std::size_t kMostFarBuildings = 1000;
/// The distance from the edge up to which there are any.
inline constexpr double kFarBuildings_m = 1500;

/// Returns the buildings within kMirrored_m of the edge of a scene, mirrored as its land cover is (patchwork.h): boxes
/// about the longest edge of their footprint, with its area, the heights, materials and tints of their walls, and a
/// gable where they have a pitched roof. Only on land of towns, industry, farms and gardens that is not steep; none
/// below 30 m² or above 32 m. One mesh for each material. O(buildings).
std::vector<materials::MaterialMesh> far_buildings(const scene::Scene& scene, const Patchwork& patchwork,
                                                   const surroundings::AroundSurface& surface);

}  // namespace citykiln::bake
