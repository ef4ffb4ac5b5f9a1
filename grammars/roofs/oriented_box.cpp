#include "grammars/roofs/oriented_box.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace citykiln::roofs {
namespace {

// The cosine of 25 degrees: compass words are up to 22.5 degrees off, and mapped angles some more.
constexpr double kNearlyAligned = 0.9063;
// Boxes whose areas differ by a smaller factor count as equal.
constexpr double kAsSmall = 0.999;

OrientedBox box_along(std::span<const Vec2> ring, Vec2 along) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  OrientedBox box{ring.front(), along, left_of(along), kFar, -kFar, kFar, -kFar};
  for (const Vec2 p : ring) {
    box.from_m = std::min(box.from_m, box.along_m(p));
    box.to_m = std::max(box.to_m, box.along_m(p));
    box.back_m = std::min(box.back_m, box.across_m(p));
    box.front_m = std::max(box.front_m, box.across_m(p));
  }
  return box;
}

OrientedBox smallest_box(std::span<const Vec2> ring) {
  OrientedBox best;
  double best_m2 = std::numeric_limits<double>::infinity(), best_edge_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    if (length(edge) == 0) continue;
    const OrientedBox box = box_along(ring, unit(edge));
    const double box_m2 = box.width_m() * box.length_m();
    const bool is_as_small = box_m2 <= best_m2 / kAsSmall && length(edge) > best_edge_m;
    if (box_m2 >= best_m2 * kAsSmall && !is_as_small) continue;
    best = box, best_m2 = box_m2, best_edge_m = length(edge);
  }
  return best;
}

// The side of the box nearest to a direction, if it is near, else the direction.
Vec2 aligned(const OrientedBox& box, Vec2 direction) {
  for (const Vec2 side : {box.along, box.across, box.along * -1, box.across * -1})
    if (dot(side, direction) > kNearlyAligned) return side;
  return direction;
}

}  // namespace

OrientedBox oriented_box(std::span<const Vec2> ring, std::optional<Vec2> direction, bool is_ridge_across) {
  assert(!ring.empty());
  const OrientedBox box = smallest_box(ring);
  if (direction && length(*direction) > 0) return box_along(ring, left_of(aligned(box, unit(*direction))) * -1);
  const bool is_turned = (box.length_m() < box.width_m()) != is_ridge_across;
  return is_turned ? box_along(ring, box.across) : box;
}

}  // namespace citykiln::roofs
