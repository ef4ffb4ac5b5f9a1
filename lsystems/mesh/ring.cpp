#include "lsystems/mesh/ring.h"

#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::lsystems {

Circle make_circle() {
  Circle circle;
  for (int i = 0; i < kMostSides; ++i) circle[i] = direction_of(static_cast<double>(i) / kMostSides);
  return circle;
}

Vec3 perpendicular_to(Vec3 axis, Vec3 v) {
  const Vec3 perpendicular = v - axis * dot(axis, v);
  if (length(perpendicular) > 1e-9 * length(v)) return unit(perpendicular);
  const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return unit(other - axis * dot(axis, other));
}

Vec3 parallel_transported(Vec3 x, Vec3 from, Vec3 to) {
  const double cosine = dot(from, to);
  // half a turn has no unique shortest rotation
  if (cosine < -0.999) return perpendicular_to(to, x);
  return perpendicular_to(to, x - (from + to) * (dot(x, to) / (1 + cosine)));
}

double sagitta(int sides) { return 1 - direction_of(0.5 / sides).x; }

int sides_of(double radius, double tolerance_m) {
  static constexpr double kSagitta[] = {0.29289321881345254, 0.07612046748871326, 0.019214719596769569,
                                        0.0048152733278031137};
  for (int i = 0; i < 4; ++i)
    if (radius * kSagitta[i] <= tolerance_m) return 4 << i;
  return kMostSides;
}

}  // namespace citykiln::lsystems
