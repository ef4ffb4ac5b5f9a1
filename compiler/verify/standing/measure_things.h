// Finds things (benches, signs) that stand on a road, a railway, a building or water without being mapped there.
#pragma once

#include <cstdint>

#include "compiler/bake/baked_tile.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The tests of the things of a tile.
struct StandingThings {
  std::uint64_t tested = 0;     ///< Number of things tested.
  std::uint64_t conflicts = 0;  ///< Number of those on roads, railways, buildings or water.
  Vec2 at;                      ///< The place of the first of these, plane metres.
  OsmId element{};              ///< Its element.
};

/// Tests the middle of every instance of a thing, except of those that are mapped in the way and of masts of contact
/// lines, which measure_assumed_masts() tests. Pedestrian streets are allowed. O(instances).
/// @param land_cover  Land cover of the tile.
StandingThings measure_things(const bake::BakedTile& tile, const scene::Chunk& chunk,
                              const ground::LandCoverIndex& land_cover);

}  // namespace citykiln::verify
