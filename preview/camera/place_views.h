// The named views of places that a scene may lack: a square, a river, a hilltop, roofs, and the skyline.
#pragma once

#include <optional>

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

// Each view is chosen by rays among places on the tiles, the nearest to the scene's core (its most densely built part)
// first, and has 2 m of free space around the eye. Deterministic. Cost: one World, some 10,000 rays.

/// Returns the view across the widest paved place that has buildings around it, at eye height. Empty: no paved place is
/// 15 m wide.
std::optional<Camera> square_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from 4 m above water, along it, with the most buildings in sight. Empty: there is no water with 40
/// m of free sight.
std::optional<Camera> river_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view down to the core from the highest ground within 3 km from which the core is visible, 15 m above
/// that ground. Empty: no such ground is 20 m higher than the core.
std::optional<Camera> hilltop_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from above the roofs at the core, in the direction with the most roofs. Empty: nothing is built.
std::optional<Camera> roofs_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view of the core from 1.5 km away or more, from the side that needs the least height. Empty: nothing is
/// built.
std::optional<Camera> skyline_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);

}  // namespace citykiln::preview
