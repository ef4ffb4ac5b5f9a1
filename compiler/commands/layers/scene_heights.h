// The heights of the ground of a whole manifest, from the graded terrain of its tiles.
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

/// Returns the height at which objects on the ground stand at p (ground::land_m): that of the land, and on roads that
/// of the tops of their kerbs. Outside all tiles it is that of the terrain in the nearest tile. O(roads near).
double land_m(const SceneHeights& heights, Vec2 p);
/// Returns the height of a face of the ground at p, for water that of its surface.
double face_m(const SceneHeights& heights, Vec2 p, const ground::FaceHeight& face);

}  // namespace citykiln::commands
