// Gives roads, and the ground under buildings, the material of the ground beside them, where a tile is seen from so far
// that they are lines.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::bake {

/// Moves each triangle of roads and of floor slabs to the primitive of the nearest other ground, counted in triangles,
/// if that had ground within the tolerance of every place of it. Its vertices have the colour of that ground and no
/// feature. Raises error_m by the certified distance, at most the tolerance: no shape moves, but borders of materials
/// do. Ground with uvs takes nothing. O(n log n).
void fade_roads(BakedTile& tile, double tolerance_m);

}  // namespace citykiln::bake
