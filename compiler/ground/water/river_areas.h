// Areas of running water, and the axes that tell their heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// No river's bank lies farther from its axis than this; beyond, its area is treated as one without axis.
inline constexpr double kMaxInfluence_m = 1008;
/// Reaches are whole multiples of this.
inline constexpr double kInfluenceStep_m = 16;

struct RiverAreas {
  std::vector<double> reach_m;    ///< By stream: a multiple of 16, at most kMaxInfluence_m; 0 where it runs in no area.
  std::vector<bool> has_no_axis;  ///< By surface: a river's area that no stream runs through, nor through its
                                  ///< neighbours, or none near enough.
};

/// Areas that share borders take their heights from each other's axes.
///
/// Guarantees: every place on a bank within the box lies within 0.8 times the reach of some stream. O(n log n) in
/// vertices and axes, plus banks times the axes that lie as far east of west.
RiverAreas find_river_axes(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                           const Box2& box);

}  // namespace citykiln::ground
