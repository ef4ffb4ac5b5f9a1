// Simplifies tiles that were joined from smaller ones. They are the inner nodes of a tile tree and have no recipes from
// which they could be baked.
#pragma once

#include <set>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::bake {

/// Removes the skirts between the parts of a joined tile. A skirt is a vertical strip below a tile's border that hides
/// gaps between neighbours of different levels; inside a joined tile all parts have one level. Vertical triangles of
/// ground, roads or water in the common border of two parts count as skirts.
///
/// @param tiles   Keys of the tiles that were joined.
/// @param tile_m  Side of these tiles, metres.
void remove_inner_skirts(BakedTile& joined, const std::set<scene::TileKey>& tiles, double tile_m);

/// Decimates ground, roads and water as one surface (simplify/decimate.h), and adds the certified distance, which is at
/// most the tolerance, to error_m. Borders between materials move by at most that distance. Vertices keep their
/// normals, colours and uvs, and lose their features.
///
/// @param square  The joined tile's square in the plane's metres, not from its origin. Vertices on its border stay, so
///                that neighbouring tiles still meet.
void simplify_terrain(BakedTile& joined, const Box2& square, double tolerance_m);

/// Removes all plants, and the lamps, things and parts of buildings, structures and props that lie within the tolerance
/// of ground, roads and water. A part is a connected set of triangles. Adds the certified distance of removed parts,
/// lamps and things to error_m. plant_error_m becomes at least the distance of the removed plants.
void drop_near_terrain(BakedTile& joined, double tolerance_m);

/// Removes features that no vertex and no instance has. Index 0, the id for "no element", stays.
void drop_unused_features(BakedTile& tile);

}  // namespace citykiln::bake
