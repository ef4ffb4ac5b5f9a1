// Assigns to each area of running water (a riverbank polygon) the streams whose axes determine its heights. The
// influence radius of a stream is the distance from its axis within which its profile gives heights.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The largest influence radius of a stream. An area with a bank farther than 790 m from every axis counts as without
/// axis: 1.25 times the distance, and some more for the sampling of axes and banks, must not exceed this radius.
inline constexpr double kMaxInfluence_m = 1008;
/// Influence radii are multiples of this.
inline constexpr double kInfluenceStep_m = 16;

struct RiverAreas {
  /// Per stream its influence radius, a multiple of kInfluenceStep_m; 0 if it runs in no area.
  std::vector<double> influence_radius_m;
  /// Per polygon: true for a river's area if no stream in it or its neighbours is near enough.
  std::vector<bool> has_no_axis;
};

/// Assigns streams to areas. Areas that share borders share streams.
/// @param box  Banks outside this box do not count.
///
/// Guarantees: every place on a bank within the box, of an area with axis, is within 0.8 times the radius of a stream.
/// O(n log n) in vertices and axes, plus banks times the axes with similar x.
RiverAreas find_river_axes(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                           const Box2& box);

}  // namespace citykiln::ground
