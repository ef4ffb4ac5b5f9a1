// The named view "street": from eye height, near the most densely built part of the scene.
#pragma once

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

/// Returns a camera on a street. Without streets it is at the core. Total. Cost: one World.
///
/// Method: 64 places on streets, the nearest to the scene's core that are at least 12 m apart, are each tried in 24
/// directions by rays at eye height. The best view is long, and has walls on both sides and free sky.
Camera street_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);

}  // namespace citykiln::preview
