// The heights of the ground of a whole manifest (a compiled scene), from the graded terrain of its tiles: the terrain
// after roads and water have cut into it.
#pragma once

#include <vector>

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// The graded terrain of each chunk. Refers to the scene.
struct SceneHeights {
  const scene::Scene& scene;
  std::vector<ground::GradedTerrain> graded;
};
/// Grades the terrain of all tiles.
SceneHeights heights_of(const scene::Scene& scene);

/// Returns the height at which objects stand at p: the height of the land, on roads of the kerbs' tops; outside all
/// tiles the height of the terrain in the nearest tile. O(roads near).
double land_m(const SceneHeights& heights, Vec2 p);
/// Returns the height of a ground face at p: the height of its height layer or, for standing water, the water's level.
double face_m(const SceneHeights& heights, Vec2 p, const ground::FaceHeight& face);

}  // namespace citykiln::commands
