#include "compiler/invent/country/split_convex.h"

#include <algorithm>

namespace citykiln::invent {
namespace {

/// The part of a convex ring to the left of a line (Sutherland and Hodgman 1974).
Ring left_part(const Ring& ring, Vec2 on_line, Vec2 direction) {
  Ring part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double before = cross(direction, a - on_line), after = cross(direction, b - on_line);
    if (before >= 0) part.push_back(a);
    if ((before > 0 && after < 0) || (before < 0 && after > 0))
      part.push_back(a + (b - a) * (before / (before - after)));
  }
  part = without_repeats(part);
  return part.size() < 3 ? Ring{} : part;
}

}  // namespace

SplitConvex split_convex(const Ring& ring, Vec2 on_line, Vec2 direction, double margin_m) {
  const Vec2 side = left_of(direction) * margin_m;
  SplitConvex split{
      left_part(ring, on_line + side, direction), left_part(ring, on_line - side, direction * -1), {}, {}};
  double first = 1e300, last = -1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double before = cross(direction, a - on_line), after = cross(direction, b - on_line);
    if ((before < 0) == (after < 0)) continue;
    const double along = dot(direction, a + (b - a) * (before / (before - after)) - on_line);
    first = std::min(first, along), last = std::max(last, along);
  }
  if (first <= last) split.from = on_line + direction * first, split.to = on_line + direction * last;
  return split;
}

}  // namespace citykiln::invent
