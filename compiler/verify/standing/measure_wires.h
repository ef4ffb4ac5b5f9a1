// Measures how high wires hang above carriageways.
#pragma once

#include <cstdint>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground/ground_index.h"

namespace citykiln::verify {

/// The wires over the carriageways of a tile.
struct WiresOverRoads {
  std::uint64_t spans = 0;  ///< Number of spans that cross a carriageway in the tile.
  std::uint64_t low = 0;    ///< Number of those with a wire lower than is allowed.
  double lowest_m = 0;      ///< The least height of a wire above a carriageway; 0 if there is none.
  Vec2 at;                  ///< The place of the lowest wire.
  OsmId lowest{};
};

/// Measures the recipes of the tile's spans, every 2 m, where they pass over a carriageway or railway in the tile.
/// O(spans · length).
/// @param land_cover  Land cover of the tile.
/// @param ground      Ground of the baked tile.
/// @param least_m     The height that is allowed.
WiresOverRoads measure_wires(const scene::Chunk& chunk, const Box2& tile, const ground::LandCoverIndex& land_cover,
                             const GroundIndex& ground, double least_m);

}  // namespace citykiln::verify
