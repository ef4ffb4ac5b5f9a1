// Blocks of roofs around a scene: its buildings along the edge, mirrored outwards as boxes with roofs.
#pragma once

#include <vector>

#include "compiler/bake/far/patchwork.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

/// The largest number of mirrored buildings, of 8 to 10 triangles each: those nearest to the edge are kept.
inline constexpr std::size_t kMostFarBuildings = 800;
/// The largest distance of a mirrored building from the edge, metres: noise moves some farther than kMirrored_m.
inline constexpr double kFarBuildings_m = 1500;

/// Returns the buildings within kMirrored_m of the edge of a scene, mirrored as its land cover is (patchwork.h).
///
/// Each becomes a box along the longest edge of its footprint, with the footprint's area, and the height and
/// colour of its walls, with rows of windows of the picture far_windows() (ColourSource::kByAtlas); walls of glass
/// have none. A building with a pitched roof gets a gable roof. Buildings stand only on land of towns,
/// industry, farms and gardens that is not steep. Buildings with a footprint below 40 m², and buildings above 32 m, are
/// left out. One mesh for each material. O(buildings).
std::vector<materials::MaterialMesh> far_buildings(const scene::Scene& scene, const Patchwork& patchwork,
                                                   const surroundings::AroundSurface& surface);

}  // namespace citykiln::bake
