// Levels of detail for pictures: the view from which cells get their tolerance. A cell has the meshes of all objects on
// one piece of the ground.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/view/view_levels.h"
#include "preview/camera/camera.h"

namespace citykiln::preview {

/// The size of pictures and the errors that cells may have in them.
struct CellFineness {
  int width_px = 0, height_px = 0;  ///< Size of each picture. > 0.
  double pixel_error = 0.5;         ///< Largest error of surfaces that pictures show, in pixels. > 0.
  /// Largest angle, seen from the eye, of errors in cells that no picture shows directly; 0: pixel_error holds for all
  /// cells. >= 0.
  double unseen_deg = 0;
  double finest_m = 0.02;  ///< The smallest tolerance, however near the eye. > 0.
};

/// Returns the eyes of all cameras, with the eyes at the end of a motion. Plane metres.
std::vector<Vec3> eyes_of(std::span<const Camera> cameras);

/// Returns the pyramid that the picture of a camera at rest shows, widened by a pixel on each side and by the radius of
/// the lens. Sight::to_sun is zero.
bake::Sight sight_of(const Camera& camera, int width_px, int height_px);

/// Returns one view for all pictures, in which the nearest eye decides the tolerance of a cell. More than 65 eyes are
/// grouped into boxes of neighbouring eyes. For a single camera at rest, unseen_deg is the limit for cells that neither
/// are in the picture nor throw a shadow of the sun into it.
/// @param cameras  Not empty.
bake::View cell_view(const scene::Scene& scene, std::span<const Camera> cameras, const CellFineness& fineness);

}  // namespace citykiln::preview
