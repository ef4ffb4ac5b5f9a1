// Connects the roads of a tile city to one network.
#pragma once

#include <cstddef>
#include <cstdint>

#include "compiler/invent/tiles/arrange_tiles.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {

/// The parts of a road network, connected within a grid.
struct RoadParts {
  std::size_t before = 0;
  std::size_t after = 0;  ///< 1, unless the set lacks tiles for a connection.
};

/// Connects all cells that roads connect (the labels after "roads" in the tile set) to one network: the shortest chain
/// of cells without roads, from each part to another one, gets tiles with a road of the first label. Neighbours keep
/// equal labels on their common side. O(cells · parts) at most; parts are few.
RoadParts connect_roads(const TileSet& set, std::uint64_t seed, TileGrid& grid);

}  // namespace citykiln::invent
