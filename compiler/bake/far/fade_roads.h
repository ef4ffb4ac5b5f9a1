// Gives roads, and the ground under buildings, the material of the ground beside them, for tiles that are seen from so
// far that roads are as thin as lines.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::bake {

/// Gives each triangle of roads, and of ground under buildings, the material and colour of the nearest other ground,
/// counted in triangles. A triangle changes only if every point of it is within the tolerance of that ground, and only
/// to ground without uvs. Its vertices lose their feature. error_m grows by the certified distance, at most the
/// tolerance: shapes stay, but borders of materials move. O(n log n).
void fade_roads(BakedTile& tile, double tolerance_m);

}  // namespace citykiln::bake
