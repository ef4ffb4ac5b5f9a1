// The heights of the ground are a few functions of the place, one for each kind of surface; where two kinds meet and
// their heights differ, a step stands between them: a kerb, a quay, a retaining wall.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

enum class HeightLayer : std::uint8_t {
  kLand,         ///< The terrain, cut and filled towards roads and water.
  kRoad,         ///< What is level with a road's kerbs: pavements, verges, islands, roads without kerbs.
  kCarriageway,  ///< What lies between kerbs, below their tops.
  kWater,
  kCount
};

/// Metres of the plane at one place, one a layer.
using Heights = std::array<double, static_cast<std::size_t>(HeightLayer::kCount)>;

inline double of(const Heights& heights, HeightLayer layer) { return heights[static_cast<std::size_t>(layer)]; }

/// The layer on which a surface lies. Areas of a road's class, squares and car parks, have no profile: they are land.
HeightLayer layer_of(const Surface& surface);

}  // namespace citykiln::ground
