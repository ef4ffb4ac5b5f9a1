// The box in which the terrain of a map is graded while the map is planned.
#pragma once

#include <algorithm>

#include "compiler/geometry/box.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// Returns the part of the extent whose terrain is known: all of it, or less if a region is compiled on its own.
inline Box2 graded_box(const Box2& extent, const map::Heightfield& terrain) {
  const Box2 known = terrain.box();
  return {{std::max(extent.min.x, known.min.x), std::max(extent.min.y, known.min.y)},
          {std::min(extent.max.x, known.max.x), std::min(extent.max.y, known.max.y)}};
}

}  // namespace citykiln::ground
