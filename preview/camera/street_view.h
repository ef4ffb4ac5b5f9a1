// The named view "street": from eye height, near the most densely built part of the scene.
#pragma once

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

/// Method: of 64 places on streets, the nearest to the scene's core that are well apart, each is tried in 24 directions
/// by rays at eye height; the best view is long, has walls on both sides and free sky. Without streets, the view is at
/// the core. Total. Cost: one World.
Camera street_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);

}  // namespace citykiln::preview
