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

/// Whether bake_surroundings() lowers the land beyond the extent by the Earth's curvature.
enum class EarthCurve {
  kAsSeen,  ///< Lowered, as one sees it. For a tile that stays in the plane.
  kNone     ///< Not lowered. For a tile that bent() (bend.h) maps to the ellipsoid afterwards.
};
/// Returns the land and sea around the tiles of the scene's chunks as one tile at one level. Empty if the header has no
/// surroundings, or the scene no chunk. Positions are plane metres from the tile's origin, as in other tiles.
///
/// - On the border of a tile, heights are those of its terrain. Tiles of the extent without a chunk are part of the
///   land around.
/// - Colours follow the land cover along the edge of the scene. Near the edge, land has the mean colour of that edge in
///   its direction; farther away this fades into the mean of all directions. Woods end at the tree line
///   (plants/tree_line.h); above it are meadow and rock, and snow above the snow line. Steep ground is rock.
/// - error_m is the error of the grid of heights. There are no features.
///
/// Guarantees: same bytes on every CPU. Cannot fail. Cost: 0.2 s.
std::optional<BakedTile> bake_surroundings(const scene::Scene& scene, EarthCurve curve = EarthCurve::kAsSeen);

}  // namespace citykiln::bake
