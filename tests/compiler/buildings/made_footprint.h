// Footprints of buildings for tests.
#pragma once

#include "compiler/map/features.h"

namespace citykiln::buildings {

inline map::Footprint footprint_on(std::int64_t id, Ring outer, double height_m) {
  map::Footprint f;
  f.id = {{OsmType::kWay, id}, 0};
  f.polygon.outer = std::move(outer);
  f.height_m = height_m;
  f.has_roof_in_height = true;
  return f;
}

inline map::Footprint rectangle(std::int64_t id, Vec2 corner, double width_m, double depth_m, double height_m) {
  const auto [x, y] = corner;
  return footprint_on(id, {{x, y}, {x + width_m, y}, {x + width_m, y + depth_m}, {x, y + depth_m}}, height_m);
}

}  // namespace citykiln::buildings
