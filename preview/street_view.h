// Standing in a street: the one near the densest part of the scene that shows most of it.
#pragma once

#include "preview/preview.h"
#include "preview/scene_grid.h"

namespace citykiln::preview {

/// Method: of 64 places on streets, nearest to the scene's core and well apart, each is tried in 24 directions by rays
/// at eye height; the best has sight ahead, walls on both sides and free sky. Without streets, on the ground at the
/// core. Total. Cost: one World.
Camera street_view(std::span<const bake::BakedTile> tiles, const SceneGrid& relief);

}  // namespace citykiln::preview
