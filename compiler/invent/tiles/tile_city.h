// A city of tiles: the objects of all cells of a grid, joined where they belong together.
#pragma once

#include <cstdint>

#include "compiler/invent/invented_map.h"
#include "compiler/invent/tiles/arrange_tiles.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {

/// Adds the objects of a grid of tiles about the middle of the world. Covers of equal tags become areas over all their
/// cells; lines of equal tags are joined where they meet; roads get names, and buildings addresses on them.
void add_tile_city(const TileSet& set, const TileGrid& grid, std::uint64_t seed, InventedMap& map);

}  // namespace citykiln::invent
