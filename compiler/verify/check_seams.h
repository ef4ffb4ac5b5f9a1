// Checks that neighbouring tiles have the same border edges.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/measure_ground.h"

namespace citykiln::verify {

/// Ground edges on the four sides of a tile at one level, to compare with the neighbouring tiles'.
struct Borders {
  BorderEdges west, east, south, north;
};

/// The borders of a tile. @param box  Its square, in plane metres.
Borders borders_of(const bake::BakedTile& tile, const Box2& box);

/// Borders by level and tile.
using BordersByTile = std::map<std::pair<std::size_t, scene::TileKey>, Borders>;

/// Compares each tile with its eastern and its northern neighbour, where both are there. Failures name the tiles.
void check_seams(const BordersByTile& borders, Check& seams);

}  // namespace citykiln::verify
