// A road at ground level: an axis and a width. What leaves the ground (bridges, tunnels) is structures/.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/surface_class.h"

namespace citykiln::roads {

struct Road {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  map::SurfaceClass surface{};
  double width_m = 0;  ///< A multiple of 2^-10, > 0.
  bool rounds_start = false,
       rounds_end = false;  ///< Ends that meet another road are round, so that no wedge is missing between them.
  double pavement_left_m = 0, pavement_right_m = 0;  ///< Beyond the kerbs, seen along the axis; multiples of 1/4 m.
  bool operator==(const Road&) const = default;
};

/// No point of the road or its pavements lies farther from its axis than this.
inline double breadth_m(const Road& road) {
  return road.width_m + 2 * std::max(road.pavement_left_m, road.pavement_right_m);
}

}  // namespace citykiln::roads
