// Plans the land around the extent from heightmaps.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"
#include "compiler/surroundings/open_water.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The spacing of height samples around the extent, to which finer heightmaps are thinned: about 3 arc seconds.
inline constexpr double kSampleSpacing_m = 95;

/// The extent that the grid surrounds.
struct Place {
  Box2 extent;                                ///< The extent.
  double tile_m = map::kDefaultTile_m;        ///< Side of its tiles.
  MappedWater water{};                        ///< Sea and lakes in the extent, and the coast around it.
  const map::Heightfield* heights = nullptr;  ///< Heights of the extent where no heightmap has any; null: 0.
};

/// Returns the grid around the extent, out to kReach_m. It is empty if there would be more than kMostLines lines.
///
/// - A vertex has the height of the first heightmap that covers it, in whole metres, or in multiples of 2, 4 or 8 m
///   beside wide cells if the extent has no sea.
/// - Vertices that no heightmap covers are extrapolated from those beside them, so that nothing ends in a wall. If no
///   heightmap covers any vertex, those are the heights of the extent.
/// - find_open_water() decides what is sea or lake. Extrapolated vertices are sea where the nearest coastline says so;
///   without coastlines they have the cover of the vertex that they continue.
///
/// Error: a heightmap's reference system is unknown. Same bytes on every CPU. Cost: 0.4 µs a sample.
/// @param rasters  Without voids, in the order of precedence.
Result<Surroundings> plan(std::span<const source::Raster> rasters, const map::Plane& plane, const Place& place);

}  // namespace citykiln::surroundings
