// Tree trunks in places where none can be: roads, railways, buildings and water.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::verify {

struct Trunks {
  std::uint64_t trees = 0;      ///< Number of trunks measured.
  std::uint64_t misplaced = 0;  ///< Trunks in a wrong place.
  Vec2 at;                      ///< Place of the first of them.
  OsmId worst{};                ///< Its tree or wood.
};

/// Measures the tile's instances that are named after a species with a trunk, such as "oak_3"; hedges and grass have
/// none. O(instances).
/// @param map  The land cover of the tile.
Trunks measure_trunks(const bake::BakedTile& tile, const ground::LandCoverIndex& map);

}  // namespace citykiln::verify
