#include "compiler/sky/horizon.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

constexpr double kFlattening = 1 / 298.257223563;  // WGS 84

// Degrees by which refraction lifts a body at this height.
double refraction_deg(double height_deg) {
  const double known_deg = std::max(height_deg, -1.0);
  const double lift_deg = 1.02 / tangent(known_deg + 10.3 / (known_deg + 5.11)) / 60;
  return std::max(0.0, lift_deg) * (height_deg < -1 ? (height_deg + 90) / 89 : 1);
}

}  // namespace

Vec3 at_horizon(Vec3 v, LonLat place, double sidereal_deg) {
  const Vec2 meridian = direction_of((sidereal_deg + place.lon_deg) / 360);
  const Vec2 latitude = direction_of(place.lat_deg / 360);
  // equatorial plane: towards the meridian, and to the east
  const double south = v.x * meridian.x + v.y * meridian.y, east = v.y * meridian.x - v.x * meridian.y;
  return {east, latitude.x * v.z - latitude.y * south, latitude.y * v.z + latitude.x * south};
}

Vec3 place_radii(LonLat place, double sidereal_deg) {
  const Vec2 meridian = direction_of((sidereal_deg + place.lon_deg) / 360);
  const Vec2 latitude = direction_of(place.lat_deg / 360);
  constexpr double kSquashed = (1 - kFlattening) * (1 - kFlattening);
  const double c = 1 / std::sqrt(latitude.x * latitude.x + kSquashed * latitude.y * latitude.y);
  return {c * latitude.x * meridian.x, c * latitude.x * meridian.y, kSquashed * c * latitude.y};
}

Vec3 refracted(Vec3 v) {
  const double level = std::sqrt(v.x * v.x + v.y * v.y);
  if (level == 0) return v;
  const double height_deg = arctangent2_deg(v.z, level);
  const Vec2 lifted = direction_of((height_deg + refraction_deg(height_deg)) / 360);
  return {v.x / level * lifted.x, v.y / level * lifted.x, lifted.y};
}

}  // namespace citykiln::sky
