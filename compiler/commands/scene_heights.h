// The heights of a whole manifest: those of its tiles' graded terrain.
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
SceneHeights heights_of(const scene::Scene& scene);

/// Returns the height at which things stand at p (ground::land_m); for water that of its surface. Outside of all tiles
/// it is the terrain's, of the nearest tile. O(roads near).
double land_m(const SceneHeights& heights, Vec2 p);
double face_m(const SceneHeights& heights, Vec2 p, const ground::FaceHeight& face);

}  // namespace citykiln::commands
