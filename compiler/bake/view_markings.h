// Lays out the marking atlas of a tile for a viewpoint: one image with the painted lines of all roads, which all parts
// of the tile share. A part is the cells and objects of a tile that have one level (view/view_levels.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Returns the atlas of all layouts (patterns of painted lines) in a tile: those of the land cover of each level, and
/// of the bridges and tunnels of each part at the part's tolerance. Its texels are as fine as the finest level of the
/// view needs. Never null; shared, so that all levels can keep it (TileLevel::markings). Cannot fail. Cost: generating
/// the structures once per part, and the atlas' texels.
/// @param parts   The levels of the parts, ascending: result of levels_of_parts().
/// @param levels  One per part: result of bare_levels_for_view() or levels_for_view() for these parts.
std::shared_ptr<const Markings> markings_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                                  const ViewLevels& view, const std::vector<int>& parts,
                                                  std::span<const TileLevel> levels);

}  // namespace citykiln::bake
