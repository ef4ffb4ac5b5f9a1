// The distance of places from water.
#pragma once

#include "compiler/invent/terrain.h"
#include "compiler/invent/town/town_raster.h"

namespace citykiln::invent {

/// The largest distance that is told apart.
inline constexpr double kFarFromWater_m = 200;

/// Distances in metres, 0 in water, at most kFarFromWater_m.
struct WaterDistance {
  TownRaster<double> distance_m;

  double at(Vec2 p) const { return distance_m.at(p); }
  /// True if a place is so near to water that it may lie in it: the lattice is as fine as this.
  bool may_be_water(Vec2 p) const { return at(p) < 1.5 * distance_m.step_m; }
};

/// Returns the distances over a square about the middle. Steps are 4 m, 1/1250 of larger worlds. Errors are below a
/// step and 5 %. Method: seas and lakes are filled row by row, rivers capsule by capsule; two passes of a chamfer
/// transform (Borgefors, "Distance transformations in digital images", 1986).
WaterDistance water_distance(const Terrain& terrain, double side_m);

}  // namespace citykiln::invent
