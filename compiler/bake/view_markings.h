// The marking atlas of a tile for a view, which all of its parts show.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Draws the layouts of the levels' roads, and those of all structures that the tile bakes, each at the level of its
/// part. Cost: generating the structures, and the atlas' texels.
/// @param parts, levels  As bare_levels_for_view() takes and returns them.
std::shared_ptr<const Markings> markings_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                                  const ViewLevels& view, const std::vector<int>& parts,
                                                  std::span<const TileLevel> levels);

}  // namespace citykiln::bake
