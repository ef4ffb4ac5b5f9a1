#include "compiler/map/plane/cylinder.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::map {

double circumference_m(const Cylinder& cylinder) { return 2 * kPi * cylinder.radius_m; }

BentPoint at(const Cylinder& cylinder, Vec3 p) {
  const double radius_m = cylinder.radius_m, left_m = radius_m - p.z;
  const Vec2 turn = direction_of(p.y / circumference_m(cylinder));
  return {.at = {p.x, left_m * turn.y, radius_m - left_m * turn.x},
          .east = {1, 0, 0},
          .north = {0, turn.x, turn.y},
          .up = {0, -turn.y, turn.x},
          .along_north = left_m / radius_m};
}

Vec3 flattened(const Cylinder& cylinder, Vec3 p, double near_y_m) {
  const double radius_m = cylinder.radius_m, down_m = radius_m - p.z, around_m = circumference_m(cylinder);
  const double y = arctangent2_deg(p.y, down_m) * (kPi / 180) * radius_m;
  return {p.x, y + around_m * std::round((near_y_m - y) / around_m), radius_m - std::sqrt(p.y * p.y + down_m * down_m)};
}

double stretch(const Cylinder& cylinder, double low_m) { return 1 + std::max(0.0, -low_m) / cylinder.radius_m; }

double sag_m(const Cylinder& cylinder, double extent_y_m, double extent_z_m, double stretch) {
  return extent_y_m * (stretch * extent_y_m + 2 * extent_z_m) / (8 * cylinder.radius_m);
}

}  // namespace citykiln::map
