// The ground of a tile that leaves layers of the ground out.
#pragma once

#include <set>
#include <utility>

#include "compiler/ground/generate.h"
#include "compiler/scene/land_cover.h"
#include "compiler/scene/shown.h"

namespace citykiln::bake {

/// The edges of faces that were removed, by their ends: the left face of each is gone.
using RemovedEdges = std::set<std::pair<Vec3, Vec3>>;

/// Removes the faces of a cell's ground beyond the clip (scene::kBeyondClip), and returns their edges. Returns none,
/// and changes nothing, where there are no such faces. O(faces · log).
RemovedEdges remove_beyond_clip(ground::GroundMesh& ground, const scene::LandCover& cover);

/// True if shown_ground() may change faces: roads, water or buildings are left out, and the land is not.
bool shows_land_for_others(const scene::Shown& shown);

/// Returns a cell's ground in which the faces of roads and water and those below buildings, where these are left out,
/// are land that is not mapped, at the same heights. O(faces).
/// @param cover  The land cover that the faces refer to.
ground::GroundMesh shown_ground(ground::GroundMesh ground, const scene::LandCover& cover, const scene::Shown& shown);

}  // namespace citykiln::bake
