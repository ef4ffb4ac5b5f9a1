// What leaves the ground: bridges, and tunnels below it.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/surface_class.h"

namespace citykiln::structures {

/// A deck or a bore along an axis. z is decided when the map is compiled.
struct Span {
  ObjectId id;
  std::vector<Vec3> axis;  ///< Plane metres, snapped; z is the top of the road.
  map::SurfaceClass surface{};
  double width_m = 0;  ///< A multiple of 2^-10, > 0.
  bool operator==(const Span&) const = default;
};

}  // namespace citykiln::structures
