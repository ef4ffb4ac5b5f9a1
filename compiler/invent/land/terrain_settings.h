// The parameters of an invented terrain.
#pragma once

#include "compiler/invent/land/diamond_square.h"
#include "compiler/invent/land/erode.h"

namespace citykiln::invent {

struct TerrainSettings {
  /// A power of 0 stands for cells of at most 8 m, but 1024 a side at most.
  DiamondSquare fractal{.power = 0, .initial_height_m = 240, .spread_m = 70, .reduction = 0.5};
  /// The side of the square, at least that of the map. 0: three times that of the map, but 4 km more at most.
  double size_m = 0;
  double ridges_m = 0;          ///< The height of ridged noise that is added.
  double ridge_length_m = 900;  ///< The distance of its largest ridges.
  Erosion erosion;
  bool has_coast = false;       ///< Part of the square is under the sea, whose level is 0.
  double coast_fall_m = 60;     ///< With a coast: how far the land sinks from one side of the map to the other.
  int lakes = 0;                ///< The largest hollows of the fractal, at most so many, become lakes.
  double river_from_km2 = 0.3;  ///< The land that makes a stream.
  double river_width_m = 3.5;   ///< The width of a river that drains 1 km²; it grows with the square root of the land.
};

}  // namespace citykiln::invent
