// The named views of places that a scene may lack: a square, water, a park, a hilltop, roofs, and the skyline.
#pragma once

#include <optional>

#include "preview/camera/camera.h"
#include "preview/camera/street_view.h"

namespace citykiln::preview {

// Cameras are in plane metres, z up. Places are chosen by rays through the tiles. The core is the scene's most densely
// built part (SceneGrid::core_point()). Every eye is under the open sky: a ray upwards meets nothing. Every view but
// roofs_view has 2 m of free space on all sides of the eye. If the sun is up, directions towards it are worth about
// half. Deterministic. Cost: some 10,000 to 100,000 rays.

/// Returns the view across a square, from near its edge, 1.7 m above the paving. Tries the 300 paved places nearest to
/// the core as the middle of a square. The best view has the largest product of: the square's width; the number of
/// directions with a building within 80 m; one more than the rays ahead that meet buildings; the free distance ahead.
/// The width is the harmonic mean of the free distances in all directions from the middle, each counted up to 60 m, so
/// that a street, which is long one way and narrow the other, counts as narrow. Empty: no square is 15 m wide with 15 m
/// free ahead.
std::optional<Camera> square_view(const ViewScene& scene);
/// Returns the view from 3 m above a river, a lake, a harbour or the sea. Tries the 240 places on water nearest to the
/// core. The best view has the most free space to the sides (counted up to 6 m), free distance ahead (up to 160 m) and
/// buildings in sight. Empty: none has 40 m free ahead.
std::optional<Camera> water_view(const ViewScene& scene);
/// Returns the view over a lawn towards trees, 1.7 m above the ground. Tries the 400 green places nearest to the core
/// around which at least 60 % of the ground within 36 m is green, a path or water. The best view has the most rays that
/// meet plants between 8 and 90 m, then buildings behind them, and free distance ahead. Empty: no plant is seen from
/// such a place.
std::optional<Camera> park_view(const ViewScene& scene);
/// Returns the view down to 10 m above the core from a hill: from 15 m above ground that is at least 30 m higher than
/// the core and 150 m to 3 km away from it. The sight must be free to within 60 m of the target. The best view has the
/// largest ratio of height above the target to the square root of the distance in plan. Empty: no such ground.
std::optional<Camera> hilltop_view(const ViewScene& scene);
/// Returns the view from 8 m above the highest surface within some 40 m of the core, downwards in the direction in
/// which the most rays meet buildings within 300 m. Empty: no ray does.
std::optional<Camera> roofs_view(const ViewScene& scene);
/// Returns the view of the core from the larger of 1.5 km and six times the core's height above its ground. The sight
/// must be free to within 200 m of the core. Tries 24 directions, and takes the one in which the eye needs the least
/// height above the ground for that, at least 6 m. Empty: no direction has such a place, or nothing at the core is
/// higher than 3 m.
std::optional<Camera> skyline_view(const ViewScene& scene);

}  // namespace citykiln::preview
