// Measures whether planned water keeps its guarantees, from its recipes (polygons with levels, watercourses with height
// profiles) and the terrain only.
#pragma once

#include <cstddef>
#include <span>

#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Numbers of waters and their largest deviations, in metres.
struct WaterMeasures {
  std::size_t streams = 0, standing = 0;
  std::size_t streams_that_rise = 0;  ///< Streams that rise along their axis, or to another at a common vertex.
  std::size_t waters_not_level = 0;   ///< Common edges of two polygons with different levels (dams).
  double largest_rise_m = 0;
  double deepest_below_land_m = 0,
         highest_above_land_m = 0;  ///< At vertices of streams, and every 16 m between them, in the terrain's box.
};

/// Measures planned water. Streams without profile count as lying on the terrain. O(n log n).
WaterMeasures measure_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                             const map::Heightfield& heights);

}  // namespace citykiln::ground
