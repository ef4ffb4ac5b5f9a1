#include "grammars/roofs/facet.h"

namespace citykiln::roofs {

Plane combined(double first, const Plane& a, double second, const Plane& b) {
  return {a.origin, a.gradient * first + b.gradient * second, first * a.offset + second * b.at(a.origin)};
}

Ring clipped(std::span<const Vec2> ring, const Plane& plane) {
  Ring kept;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Vec2 p = ring[i], q = ring[(i + 1) % n];
    const double zp = plane.at(p), zq = plane.at(q);
    if (zp >= 0) kept.push_back(p);
    if ((zp < 0 && zq > 0) || (zp > 0 && zq < 0)) kept.push_back(p + (q - p) * (zp / (zp - zq)));
  }
  return kept.size() < 3 ? Ring{} : kept;
}

Plane distance_left_of(Vec2 a, Vec2 b) { return {a, left_of(unit(b - a)), 0}; }

}  // namespace citykiln::roofs
