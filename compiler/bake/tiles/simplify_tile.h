// Simplifies tiles that were joined from smaller ones: inner tiles of a tile tree, which have no recipes.
#pragma once

#include <set>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::bake {

/// Removes the skirts between the tiles of a joined tile. Skirts hide gaps between levels, and all of its tiles have
/// one level. Vertical triangles of ground, roads or water in the border of two tiles count as skirts.
/// @param tiles  The tiles that were joined.
void remove_inner_skirts(BakedTile& joined, const std::set<scene::TileKey>& tiles, double tile_m);

/// Decimates ground, roads and water as one surface (simplify/decimate.h); adds the certified distance, which is at
/// most the tolerance, to error_m. Materials keep their outlines within that distance; vertices keep their normals,
/// colours and uvs, and lose their features.
/// @param square  The square of the joined tile in the plane. Vertices on its border stay, so that joined tiles side by
///                side meet as before.
void simplify_terrain(BakedTile& joined, const Box2& square, double tolerance_m);

/// Removes all plants, and parts of buildings, structures and props that are within the tolerance of ground, roads and
/// water. Adds the certified distance of the parts to error_m. A part is a connected set of triangles. plant_error_m
/// becomes at least the plants' distance.
void drop_near_terrain(BakedTile& joined, double tolerance_m);

/// Removes features without vertices and instances. The none feature stays.
void drop_unused_features(BakedTile& tile);

}  // namespace citykiln::bake
