// The named views of places that a scene may lack: a square, a river, a hilltop, roofs, and the skyline.
#pragma once

#include <optional>

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

// Views are chosen by rays. The core is the scene's most densely built part (SceneGrid::core_point()). All but
// roofs_view have 2 m of free space on all sides of the eye. Deterministic. Cost: one World, some 10,000 rays.

/// Returns the view across a square under the open sky, from near its edge, 2.4 m above the paving: the best by width,
/// share of directions with a building within 80 m, buildings ahead and free distance ahead. The width is the harmonic
/// mean of the free distances around its middle, each up to 60 m. Tries the 300 paved places nearest to the core.
/// Empty: none is 15 m wide with 15 m free ahead.
std::optional<Camera> square_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from 4 m above water under the open sky: the best by free space to the sides, up to 6 m, free
/// distance ahead, up to 400 m, and buildings in sight. Tries the 150 places on water nearest to the core. Empty: none
/// has 40 m free ahead.
std::optional<Camera> river_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view down to 10 m above the core, from 15 m above ground that is at least 30 m higher than the core and
/// 150 m to 3 km away, with free sight to within 60 m of it: the best by height over the root of the distance. Empty:
/// no such ground.
std::optional<Camera> hilltop_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from 8 m above the highest surface within some 40 m of the core, downwards in the direction in
/// which the most rays meet buildings within 300 m. Empty: no ray does.
std::optional<Camera> roofs_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view of the core from 1.5 km away, or six times its height, under the open sky, with free sight to
/// within 200 m of it; of 24 directions the one that needs the least height above the ground there, at least 6 m.
/// Empty: no direction has such a place, or nothing at the core is higher than 3 m.
std::optional<Camera> skyline_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);

}  // namespace citykiln::preview
