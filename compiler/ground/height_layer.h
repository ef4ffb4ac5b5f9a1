// Height layers: the ground has several heights at each place of the map, each a function of the place. Each kind of
// land cover follows one of these functions. Where faces of two layers meet at different heights, a vertical face joins
// them: a kerb, a quay, a retaining wall.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The height functions.
enum class HeightLayer : std::uint8_t {
  kLand,         ///< The terrain, changed by landforms, cut and filled beside roads and water.
  kRoad,         ///< The height of kerbs' tops: pavements, cycle tracks, verges, islands.
  kCarriageway,  ///< The height between kerbs, below their tops; of a road or rail without kerbs that of kRoad.
  kWater,        ///< The surface of rivers, lakes and the sea.
  kCount         ///< The number of layers.
};

/// The number of layers as a size.
inline constexpr auto kHeightLayers = static_cast<std::size_t>(HeightLayer::kCount);

/// Heights in metres above the map plane at one place, one per layer: index with HeightLayer or use layer_height_m().
using Heights = std::array<double, kHeightLayers>;

inline double layer_height_m(const Heights& heights, HeightLayer layer) {
  return heights[static_cast<std::size_t>(layer)];
}

/// Returns the layer of a polygon. Areas with a road's class (squares, car parks), and paths without a profile of
/// heights, lie on the land.
HeightLayer layer_of(const LandCoverPolygon& surface);

/// The height of a face: the height of its layer or, for standing water, one level for the whole face, even where its
/// shore has been simplified.
struct FaceHeight {
  HeightLayer layer = HeightLayer::kLand;
  std::optional<double> level_m;

  bool operator==(const FaceHeight&) const = default;
};
/// Returns the height rule of a polygon's faces.
FaceHeight face_height_of(const LandCoverPolygon& surface);

inline double layer_height_m(const Heights& heights, const FaceHeight& face) {
  return face.level_m ? *face.level_m : layer_height_m(heights, face.layer);
}

}  // namespace citykiln::ground
