// Bakes the land and sea around the tiles of a scene as a tile of its own.
#pragma once

#include <limits>
#include <optional>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The key of the tile with the surroundings. No other tile has it.
inline constexpr scene::TileKey kSurroundingsTile{std::numeric_limits<std::int32_t>::max(),
                                                  std::numeric_limits<std::int32_t>::max()};

/// Choice to lower heights by the Earth's curvature, or not, for a tile that bend.h maps to the ellipsoid.
enum class EarthCurve {
  kAsSeen,  ///< Heights beyond the extent are lowered, for a flat tile.
  kNone     ///< Heights stay, for a tile that bend.h maps.
};
/// Returns the land and sea around the scene's chunks as one level; nothing if the header has no surroundings.
///
/// - At the borders of tiles, heights are those of their terrain. Beyond the extent, kAsSeen lowers them by the Earth's
///   curvature. Tiles of the extent without a chunk are part of the land around.
/// - Colours at the edge are means of its land cover by direction, which fade into the mean of all directions. Woods
///   end at the tree line (plants/tree_line.h); above it are meadow and rock, and snow above the snow line. Steep
///   ground is rock.
/// - error_m is the error of the grid's heights. There are no features.
///
/// Guarantees: same bytes on every CPU. Cost: 0.2 s.
std::optional<BakedTile> bake_surroundings(const scene::Scene& scene, EarthCurve curve = EarthCurve::kAsSeen);

}  // namespace citykiln::bake
