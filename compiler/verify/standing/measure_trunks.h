// Finds trees whose trunks stand on a road, a railway, a building or water, where none may stand.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/plants/species_table.h"

namespace citykiln::verify {

/// The tests of the trunks of a tile.
struct Trunks {
  std::uint64_t tested = 0;     ///< Number of trunks tested.
  std::uint64_t conflicts = 0;  ///< Number of those on roads, railways, buildings or water.
  Vec2 at;                      ///< The place of the first of these, plane metres.
  OsmId element{};              ///< Its tree or wood.
};

/// Tests every instanced plant of a tile that has a trunk, which excludes hedges, grass and reed. Plants are recognised
/// by the name of their mesh, such as "oak_3". Pedestrian streets are allowed. O(instances).
/// @param land_cover  Land cover of the tile.
/// @param species     The species of the scene.
Trunks measure_trunks(const bake::BakedTile& tile, const ground::LandCoverIndex& land_cover,
                      const plants::SpeciesTable& species = plants::shipped_table());

}  // namespace citykiln::verify
