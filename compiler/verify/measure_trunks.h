// Finds tree trunks on roads, railways, buildings and water.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::verify {

/// The trunks of a tile.
struct Trunks {
  std::uint64_t trees = 0;      ///< Number of trunks measured.
  std::uint64_t misplaced = 0;  ///< Trunks in a wrong place.
  Vec2 at;                      ///< The place of the first misplaced trunk.
  OsmId worst{};                ///< The tree or wood of that trunk.
};

/// Measures the tile's instances with the name of a species that has a trunk, such as "oak_3"; hedges and grass have
/// none. O(instances).
Trunks measure_trunks(const bake::BakedTile& tile, const ground::LandCoverIndex& map);

}  // namespace citykiln::verify
