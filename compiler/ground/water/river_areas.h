// Connects areas of running water with the axes that decide their heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Largest influence radius of a stream; an area with a bank farther from every axis counts as one without axis.
inline constexpr double kMaxInfluence_m = 1008;
/// Influence radii are multiples of this.
inline constexpr double kInfluenceStep_m = 16;

struct RiverAreas {
  std::vector<double>
      reach_m;  ///< Per stream: its influence radius, a multiple of kInfluenceStep_m; 0 where it runs in no area.
  std::vector<bool>
      has_no_axis;  ///< Per polygon: a river's area without a stream through it or its neighbours near enough.
};

/// Assigns streams to areas; areas that share borders share streams.
///
/// Guarantees: every place on a bank within the box lies within 0.8 times the radius of some stream. O(n log n) in
/// vertices and axes, plus banks times the axes that lie as far east or west.
RiverAreas find_river_axes(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                           const Box2& box);

}  // namespace citykiln::ground
