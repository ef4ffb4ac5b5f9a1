// Land cover for tests of plants.
#pragma once

#include "compiler/geometry/polygon.h"
#include "compiler/ground/recipe.h"

namespace citykiln::plants {

inline ground::LandCoverPolygon surface(std::int64_t id, map::LandCoverClass kind, Ring ring) {
  const auto area = static_cast<std::uint32_t>(signed_area_m2(ring));
  return {{{OsmType::kWay, id}, 0}, kind, area, {std::move(ring)}};
}

/// A rectangle from (x0, y0) to (x1, y1).
inline Ring block(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

}  // namespace citykiln::plants
