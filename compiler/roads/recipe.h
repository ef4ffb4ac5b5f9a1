// A road at ground level: an axis and a width. What leaves the ground (bridges, tunnels) is structures/.
#pragma once

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
  bool operator==(const Road&) const = default;
};

}  // namespace citykiln::roads
