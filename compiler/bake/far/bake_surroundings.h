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
/// - Land cover goes on as at the edge (patchwork.h), with its colours there (far_land.h); with it buildings
///   (far_buildings.h), and roads and rivers that leave the scene (far_ways.h).
/// - error_m is the error of the grid of heights, plus the distance of the mesh from it. There are no features.
///
/// Guarantees: same bytes on every CPU. Cannot fail. Cost: 0.5 s.
std::optional<BakedTile> bake_surroundings(const scene::Scene& scene, EarthCurve curve = EarthCurve::kAsSeen);

}  // namespace citykiln::bake
