// The heights of the ground are a few functions of the place, one for each kind of surface; where two kinds meet and
// their heights differ, a step stands between them: a kerb, a quay, a retaining wall.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

enum class HeightLayer : std::uint8_t {
  kLand,         ///< The terrain, cut and filled towards roads and water.
  kRoad,         ///< What is level with a road's kerbs: pavements, verges, islands, roads without kerbs.
  kCarriageway,  ///< What lies between kerbs, below their tops.
  kWater,
  kCount
};

inline constexpr auto kHeightLayers = static_cast<std::size_t>(HeightLayer::kCount);

/// Metres of the plane at one place, one a layer.
using Heights = std::array<double, kHeightLayers>;

inline double of(const Heights& heights, HeightLayer layer) { return heights[static_cast<std::size_t>(layer)]; }

/// The layer on which a surface lies. Areas of a road's class, squares and car parks, have no profile: they are land.
/// Paths are land too, unless they are graded.
HeightLayer layer_of(const LandCoverPolygon& surface);

/// How high a face lies: as its layer does; standing water at its one level, even where its shore has been simplified.
struct FaceHeight {
  HeightLayer layer = HeightLayer::kLand;
  std::optional<double> level_m;

  bool operator==(const FaceHeight&) const = default;
};
FaceHeight face_height_of(const LandCoverPolygon& surface);

inline double of(const Heights& heights, const FaceHeight& face) {
  return face.level_m ? *face.level_m : of(heights, face.layer);
}

}  // namespace citykiln::ground
