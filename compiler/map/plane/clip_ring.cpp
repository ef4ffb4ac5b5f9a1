#include "compiler/map/plane/clip_ring.h"

#include <cassert>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::map {
namespace {

// One side of a box: limits the coordinate `axis` from below or from above.
struct Side {
  double Vec2::*axis;
  double Vec2::*other;
  double limit;
  bool is_lower;

  bool holds(Vec2 p) const { return is_lower ? p.*axis >= limit : p.*axis <= limit; }
  Vec2 crossing(Vec2 a, Vec2 b) const {
    Vec2 p;
    p.*axis = limit;
    p.*other = snapped_to(kMapStep_m, a.*other + (b.*other - a.*other) * ((limit - a.*axis) / (b.*axis - a.*axis)));
    return p;
  }
};

Ring on_one_side(std::span<const Vec2> ring, const Side& side) {
  Ring kept;
  const auto push = [&](Vec2 p) {
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (side.holds(a)) push(a);
    // from the lower end, so that the reversed edge is cut at the same point
    if (side.holds(a) != side.holds(b)) push(a < b ? side.crossing(a, b) : side.crossing(b, a));
  }
  if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

}  // namespace

Ring clip_ring(std::span<const Vec2> ring, const Box2& box) {
  assert(!box.is_empty());
  Ring kept(ring.begin(), ring.end());
  for (const Side& side : {Side{&Vec2::x, &Vec2::y, box.min.x, true}, Side{&Vec2::x, &Vec2::y, box.max.x, false},
                           Side{&Vec2::y, &Vec2::x, box.min.y, true}, Side{&Vec2::y, &Vec2::x, box.max.y, false}})
    kept = on_one_side(kept, side);
  return kept.size() < 3 ? Ring{} : kept;
}

}  // namespace citykiln::map
