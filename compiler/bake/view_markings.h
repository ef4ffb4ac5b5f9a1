// Draws the marking atlas of a tile for a view, which all of its parts share.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Draws the layouts of the levels' roads, and of all structures of the tile, each at the level of its part. Cost:
/// generating the structures, and the atlas' texels.
/// @param parts, levels  Argument and result of bare_levels_for_view().
std::shared_ptr<const Markings> markings_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                                  const ViewLevels& view, const std::vector<int>& parts,
                                                  std::span<const TileLevel> levels);

}  // namespace citykiln::bake
