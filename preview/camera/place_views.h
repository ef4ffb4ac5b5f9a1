// The named views of places that a scene may lack: a square, a river, a hilltop, roofs, and the skyline.
#pragma once

#include <optional>

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

// All functions have the same parameters: the baked tiles of a scene, and the SceneGrid of these tiles. Cameras are in
// plane metres, z up. Places are chosen by rays through the tiles. The core is the scene's most densely built part
// (SceneGrid::core_point()). "Under the open sky" means that nothing is above the eye within 100 m. All views but
// roofs_view have 2 m of free space on all sides of the eye. Deterministic. Cost: one World, some 10,000 rays.

/// Returns the view across a square under the open sky, from near its edge, 2.4 m above the paving. Tries the 300 paved
/// places nearest to the core as the middle of a square. The best view has the largest product of: the square's width;
/// the number of directions with a building within 80 m; one more than the rays ahead that meet buildings; the free
/// distance ahead. The width is the harmonic mean of the free distances in all directions from the middle, each counted
/// up to 60 m, so that a street, which is long one way and narrow the other, counts as narrow. Empty: no square is 15 m
/// wide with 15 m free ahead.
std::optional<Camera> square_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from 4 m above water under the open sky. Tries the 150 places on water nearest to the core. The
/// best view has the most free space to the sides (counted up to 6 m), free distance ahead (up to 400 m) and buildings
/// in sight. Empty: none has 40 m free ahead.
std::optional<Camera> river_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view down to 10 m above the core from a hill: from 15 m above ground that is at least 30 m higher than
/// the core and 150 m to 3 km away from it. The sight must be free to within 60 m of the target. The best view has the
/// largest ratio of height above the target to the square root of the distance in plan. Empty: no such ground.
std::optional<Camera> hilltop_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view from 8 m above the highest surface within some 40 m of the core, downwards in the direction in
/// which the most rays meet buildings within 300 m. Empty: no ray does.
std::optional<Camera> roofs_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
/// Returns the view of the core from the larger of 1.5 km and six times the core's height above its ground, under the
/// open sky. The sight must be free to within 200 m of the core. Tries 24 directions, and takes the one in which the
/// eye needs the least height above the ground for that, at least 6 m. Empty: no direction has such a place, or nothing
/// at the core is higher than 3 m.
std::optional<Camera> skyline_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);

}  // namespace citykiln::preview
