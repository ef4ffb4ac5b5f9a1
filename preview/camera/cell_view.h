// The view for which the cells of a scene are baked, from the cameras of its pictures.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/view_levels.h"
#include "preview/camera/camera.h"

namespace citykiln::preview {

/// How fine the cells of pictures are.
struct CellFineness {
  int width_px = 0, height_px = 0;  ///< Of each picture. > 0.
  double pixel_error = 0.5;         ///< Largest error of what pictures show, pixels. > 0.
  double unseen_deg = 0;            ///< Largest angle of errors that only scattered light and reflections show. >= 0.
  double finest_m = 0.02;           ///< The smallest tolerance, however near the eye. > 0.
};

/// The eyes of cameras, those at the end of a motion too. Plane metres.
std::vector<Vec3> eyes_of(std::span<const Camera> cameras);

/// What a camera at rest shows, two pixels and its lens wider; without a sun.
bake::Sight sight_of(const Camera& camera, int width_px, int height_px);

/// The view of all pictures together: the nearest eye counts; of more than 65 eyes, boxes of neighbouring ones. What a
/// single picture of a camera at rest does not show, nor a shadow of the sun in it, may have errors up to the larger
/// angle.
/// @param cameras  Not empty.
bake::View cell_view(const scene::Scene& scene, std::span<const Camera> cameras, const CellFineness& fineness);

}  // namespace citykiln::preview
