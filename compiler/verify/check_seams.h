// Checks that neighbouring tiles have the same border edges.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/ground/border_edges.h"

namespace citykiln::verify {

/// The ground edges on the four sides of a tile at one level, for comparison with the neighbouring tiles.
struct Borders {
  BorderEdges west, east, south, north;
};

/// Returns the ground edges on the sides of a tile, in plane metres.
///
/// @param box  The tile's square, in plane metres.
Borders borders_of(const bake::BakedTile& tile, const Box2& box);

/// The borders of tiles, by level and tile.
using BordersByTile = std::map<std::pair<std::size_t, scene::TileKey>, Borders>;

/// Compares each tile with its eastern and its northern neighbour at the same level, if both are present. Adds a test
/// for each pair to `seams`; failures name the tiles.
void check_seams(const BordersByTile& borders, Check& seams);

}  // namespace citykiln::verify
