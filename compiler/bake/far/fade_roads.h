// Gives roads, and the ground under buildings, the material of the ground beside them, for tiles that are seen from so
// far that roads are as thin as lines.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::bake {

/// Moves each triangle of roads and of ground under buildings to the primitive of the nearest other ground, counted in
/// triangles, if every point of the triangle is within the tolerance of that primitive. Its vertices get the colour of
/// that ground and no feature. Triangles are never moved to ground with uvs. error_m grows by the certified distance,
/// at most the tolerance: shapes stay, but borders of materials move. O(n log n).
void fade_roads(BakedTile& tile, double tolerance_m);

}  // namespace citykiln::bake
