// Plans the land around the extent by the heightmaps.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/plane.h"
#include "compiler/source/raster.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// Samples of heightmaps up to so far apart will do around the extent: those of 3 arc seconds and finer.
inline constexpr double kSampleSpacing_m = 95;

/// Heightmaps that know less than this distance from the extent say nothing about its surroundings.
inline constexpr double kLeastKnown_m = 1000;

/// What the grid is planned for.
struct Place {
  Box2 region;                                  ///< The extent.
  double tile_m = 1024;                         ///< Of its tiles.
  std::vector<ground::LandCoverPolygon> sea{};  ///< Of the extent. Where there is none, there is none beyond it.
};

/// Returns the grid around the extent, out to kReach_m, or an empty one where no heightmap knows a place kLeastKnown_m
/// away.
///
/// - A vertex has the height of the first heightmap that covers it, rounded to whole metres, or to 2, 4, 8 m where its
///   cells are wide and no coast needs more.
/// - Vertices that none covers have the height of the nearest known one of their row, which fades into the mean of all
///   known heights, or is sea beside sea: nothing ends in a wall.
/// - Where the extent has a coast, heights up to 0 are sea beyond it: heightmaps of 1 to 3 arc seconds have 0 at sea.
/// In
///   the extent the coastline says what is sea.
///
/// Error: a heightmap's reference system is unknown. Same bytes on every CPU. Cost: 0.4 µs a sample.
/// @param rasters  Without voids, in the order of precedence.
Result<Surroundings> plan(std::span<const source::Raster> rasters, const map::Plane& plane, const Place& place);

}  // namespace citykiln::surroundings
