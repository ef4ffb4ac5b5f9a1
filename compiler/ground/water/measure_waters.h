// What water keeps and does not keep, measured from its recipes and the land alone.
#pragma once

#include <cstddef>
#include <span>

#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

struct WaterMeasures {
  std::size_t streams = 0, standing = 0;
  std::size_t streams_that_rise = 0;  ///< Somewhere along their axis, or from one to another at a vertex in common.
  std::size_t waters_not_level = 0;   ///< Pairs of surfaces with a level that share an edge, at heights other than
                                      ///< each other's (a dam parts them).
  double largest_rise_m = 0;
  double deepest_below_land_m = 0, highest_above_land_m = 0;  ///< Of streams, at knots and vertices in the field's box.
};

/// Streams without profile count as lying on the land. O(n log n).
WaterMeasures measure_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                             const map::Heightfield& heights);

/// How high a strip's water lies over a place of its whole way; the land's height where it has no profile.
double water_at_station_m(const roads::Strip& stream, double at_m, Vec2 there, const map::Heightfield& heights);

}  // namespace citykiln::ground
