// Plans the land around the extent from heightmaps.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/raster.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The spacing of height samples around the extent, to which finer heightmaps are thinned: about 3 arc seconds.
inline constexpr double kSampleSpacing_m = 95;

/// The distance from the extent up to which heights alone are not worth a grid: without a known height at this distance
/// or beyond, there are no surroundings.
inline constexpr double kLeastKnown_m = 1000;

/// The extent that the grid surrounds.
struct Place {
  Box2 extent;                                  ///< The extent.
  double tile_m = map::kDefaultTile_m;          ///< Side of its tiles.
  std::vector<ground::LandCoverPolygon> sea{};  ///< Sea in the extent. Empty: there is no sea around it either.
};

/// Returns the grid around the extent, out to kReach_m. It is empty if no heightmap covers a vertex kLeastKnown_m away
/// or farther, or if there would be more than kMostLines lines.
///
/// - A vertex has the height of the first heightmap that covers it, in whole metres, or in multiples of 2, 4 or 8 m
///   beside wide cells if the extent has no sea.
/// - Vertices that no heightmap covers are extrapolated from those beside them, so that nothing ends in a wall.
/// - If the extent has sea, vertices outside of it with heights up to 0 are sea, as heightmaps of 1 to 3 arc seconds
/// are 0 at sea. Inside the extent, the mapped coastline decides.
///
/// Error: a heightmap's reference system is unknown. Same bytes on every CPU. Cost: 0.4 µs a sample.
/// @param rasters  Without voids, in the order of precedence.
Result<Surroundings> plan(std::span<const source::Raster> rasters, const map::Plane& plane, const Place& place);

}  // namespace citykiln::surroundings
