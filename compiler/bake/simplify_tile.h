// Simplifies tiles that were joined from smaller ones: inner tiles of a tile tree, for which no recipe is left to cut.
#pragma once

#include <set>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::bake {

/// Removes the skirts between tiles of a joined tile. They hide gaps between levels, and its tiles have one level. A
/// skirt is a vertical triangle of ground, roads or water in the border of two tiles.
/// @param tiles  Those that were joined.
void remove_inner_skirts(BakedTile& joined, const std::set<scene::TileKey>& tiles, double tile_m);

/// Decimates ground, roads and water as one surface (simplify/decimate.h); raises error_m by the certified distance,
/// which is at most the tolerance. Materials keep their outlines within that distance; vertices keep their normals,
/// colours and uvs, and belong to no feature.
/// @param square  Of the plane: what lies on its border stays, so that joined tiles side by side meet as before.
void simplify_terrain(BakedTile& joined, const Box2& square, double tolerance_m);

/// Removes plants, and parts of buildings, structures and props that are within the tolerance of ground, roads and
/// water; raises error_m by their certified distance. A part is a connected set of triangles. plant_error_m becomes at
/// least the plants' distance.
void drop_near_terrain(BakedTile& joined, double tolerance_m);

/// Removes features that no vertex and no instance has. The none feature stays.
void drop_unused_features(BakedTile& tile);

}  // namespace citykiln::bake
