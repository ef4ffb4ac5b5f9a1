// Draws the marking atlas of a tile for a viewpoint: one image with the painted lines of all roads, which all parts of
// the tile share.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Draws the layouts (patterns of lines) of the roads of all parts, and of all structures of the tile, each at the
/// tolerance of its part. Cost: generating the structures, and the atlas' texels.
/// @param parts   Levels of the parts: result of levels_of_parts().
/// @param levels  Result of bare_levels_for_view() for these parts.
std::shared_ptr<const Markings> markings_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                                  const ViewLevels& view, const std::vector<int>& parts,
                                                  std::span<const TileLevel> levels);

}  // namespace citykiln::bake
