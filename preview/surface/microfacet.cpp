#include "preview/surface/microfacet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "preview/turn.h"

namespace citykiln::preview {

Frame frame_about(Vec3 n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

double Microfacets::lambda(Vec3 from) const {
  const double z2 = from.z * from.z;
  return (std::sqrt(1 + alpha * alpha * (from.x * from.x + from.y * from.y) / z2) - 1) / 2;
}

double Microfacets::density(Vec3 facet) const {
  const double a2 = alpha * alpha, level2 = facet.x * facet.x + facet.y * facet.y;
  // not z² (a² - 1) + 1, which loses all digits where alpha is small
  const double d = facet.z * facet.z * a2 + level2;
  return a2 / (std::numbers::pi * d * d);
}

double Microfacets::seen(Vec3 from) const { return 1 / (1 + lambda(from)); }

double Microfacets::seen(Vec3 from, Vec3 other) const { return 1 / (1 + lambda(from) + lambda(other)); }

Vec3 Microfacets::sample(Vec3 from, UnitPair chance) const {
  assert(from.z > 0);
  const Vec3 view = unit(Vec3{alpha * from.x, alpha * from.y, from.z});
  const double level = std::sqrt(view.x * view.x + view.y * view.y);
  const Vec3 across = level > 0 ? Vec3{-view.y / level, view.x / level, 0} : Vec3{1, 0, 0};
  const Vec3 other = cross(view, across);
  const Vec2 round = on_circle(chance.v) * std::sqrt(chance.u);
  const double a = round.x, whole = round.y, s = (1 + view.z) / 2;
  const double b = (1 - s) * std::sqrt(std::max(0.0, 1 - a * a)) + s * whole;
  const Vec3 facet = across * a + other * b + view * std::sqrt(std::max(0.0, 1 - a * a - b * b));
  return unit(Vec3{alpha * facet.x, alpha * facet.y, std::max(1e-9, facet.z)});
}

double Microfacets::pdf(Vec3 facet, Vec3 from) const {
  return density(facet) * seen(from) * std::max(0.0, dot(facet, from)) / from.z;
}

}  // namespace citykiln::preview
