#include "compiler/sky/inside/thin_air.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"

namespace citykiln::sky {
namespace {

// The integral of exp(s²) from 0 to u. Outside of the cylinder u is clamped, where the air is rock.
double integral_of_growth(double u) {
  u = std::clamp(u, -4.0, 4.0);
  const double square = u * u;
  double term = u, sum = u;
  for (int k = 1; k < 80 && std::abs(term) > 1e-17 * std::abs(sum); ++k) {
    term *= square / k;
    sum += term / (2 * k + 1);
  }
  return sum;
}

double squared_from_axis_m2(const Inside& inside, Vec3 p) {
  const double down_m = inside.cylinder.radius_m - p.z;
  return p.y * p.y + down_m * down_m;
}

}  // namespace

double density_at(const Inside& inside, Vec3 p) {
  const double radius_m = inside.cylinder.radius_m;
  return exponential(-inside.fall * (1 - squared_from_axis_m2(inside, p) / (radius_m * radius_m)));
}

double column_m(const Inside& inside, Vec3 from, Vec3 direction, double distance_m) {
  const double radius_m = inside.cylinder.radius_m;
  const double speed2 = direction.y * direction.y + direction.z * direction.z;
  const double growth = std::sqrt(inside.fall * speed2) / radius_m;
  // along the axis the density hardly changes
  if (growth * distance_m < 1e-6) return distance_m * density_at(inside, from + direction * (distance_m / 2));
  const double nearest_m = -(from.y * direction.y + (from.z - radius_m) * direction.z) / speed2;
  const double least = density_at(inside, from + direction * nearest_m);
  return least / growth *
         (integral_of_growth(growth * (distance_m - nearest_m)) - integral_of_growth(-growth * nearest_m));
}

}  // namespace citykiln::sky
