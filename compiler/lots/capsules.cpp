#include "compiler/lots/capsules.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/segment.h"

namespace citykiln::lots {

Capsules index_capsules(std::vector<Capsule> all) {
  constexpr double kBucket_m = 32;
  Capsules capsules{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const Capsule& c : capsules.all) boxes.push_back(box_of_segment(c.a, c.b).widened(c.radius_m));
  if (!boxes.empty()) capsules.grid = grid_of(boxes, kBucket_m);
  return capsules;
}

double clearance_m(const Capsules& capsules, Vec2 p, double search_m) {
  double least_m = search_m;
  any_about(capsules.grid, Box2{p, p}.widened(search_m), [&](std::uint32_t i) {
    const Capsule& c = capsules.all[i];
    least_m = std::min(least_m, distance_to_segment(c.a, c.b, p) - c.radius_m);
    return false;
  });
  return least_m;
}

bool axis_enters(const Capsules& capsules, const Polygon& polygon) {
  if (capsules.all.empty() || polygon.outer.empty()) return false;
  for (const std::uint32_t i : boxes_about(capsules.grid, box_of(polygon.outer))) {
    const Capsule& c = capsules.all[i];
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      if (contains(polygon, c.a + (c.b - c.a) * share)) return true;
  }
  return false;
}

}  // namespace citykiln::lots
