// Whether trees stand where none can: in carriageways, rails, buildings or water.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::verify {

struct Trunks {
  std::uint64_t trees = 0;      ///< Looked at.
  std::uint64_t misplaced = 0;  ///< Of them.
  Vec2 at;                      ///< Of the first of those.
  OsmId worst{};                ///< Whose it is.
};

/// Of the tile's instances those that are named after a species with a trunk: "oak_3". Hedges may stand anywhere, and
/// blades have none.
///
/// @param map  What covers the ground of the tile.
/// O(instances).
Trunks measure_trunks(const bake::BakedTile& tile, const ground::LandCoverIndex& map);

}  // namespace citykiln::verify
