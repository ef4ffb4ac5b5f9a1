// Invents a world: a map and the heights under it.
#pragma once

#include <optional>

#include "compiler/contract/result.h"
#include "compiler/invent/invent_settings.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"
#include "compiler/invent/tiles/arrange_tiles.h"

namespace citykiln::invent {

struct InventedWorld {
  Terrain terrain;
  InventedMap map;
  Vec2 spot;       ///< Where a viewer stands (spawn_plants.h).
  TileGrid tiles;  ///< Empty for other kinds than tiles.
};

/// Returns the world of the settings. A function of them: every CPU gives the same bits.
/// @param tile_set  For the kind tiles.
/// Error: no arrangement of the tile set was found.
Result<InventedWorld> invent(const InventSettings& settings, const TileSet& tile_set);

}  // namespace citykiln::invent
