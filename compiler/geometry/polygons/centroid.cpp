#include "compiler/geometry/polygons/centroid.h"

#include <cassert>

namespace citykiln {

Vec2 centroid(const Polygon& polygon) {
  assert(!polygon.outer.empty());
  // offsets from a corner, so that products keep their digits far from the origin
  const Vec2 from = polygon.outer.front();
  Vec2 moment;
  double twice_area_m2 = 0;
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Vec2 a = (*ring)[i] - from, b = (*ring)[(i + 1) % ring->size()] - from;
      moment = moment + (a + b) * cross(a, b);
      twice_area_m2 += cross(a, b);
    }
  return twice_area_m2 == 0 ? from : from + moment * (1 / (3 * twice_area_m2));
}

}  // namespace citykiln
