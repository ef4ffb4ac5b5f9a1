// Buildings for tests of roads.
#pragma once

#include <algorithm>

#include "compiler/map/features.h"

namespace citykiln::roads {

/// A building on the ground, 9 m high.
inline map::Footprint made_footprint(std::int64_t id, Ring ring) {
  if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
  map::Footprint footprint;
  footprint.id = {{OsmType::kWay, id}, 0};
  footprint.polygon.outer = std::move(ring);
  footprint.height_m = 9;
  return footprint;
}

inline map::Footprint made_box(std::int64_t id, Vec2 min, Vec2 max) {
  return made_footprint(id, {min, {max.x, min.y}, max, {min.x, max.y}});
}

}  // namespace citykiln::roads
