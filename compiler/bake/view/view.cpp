#include "compiler/bake/view/view.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/snap.h"

namespace citykiln::bake {

double focal_length_px(int height_px, double vertical_fov_deg) {
  assert(height_px > 0 && vertical_fov_deg > 0 && vertical_fov_deg < 180);
  return snapped(height_px / 2.0 / tangent(vertical_fov_deg / 2));
}

double tolerance_m_of(const View& view, int level) {
  return level == kNoLevel ? std::numeric_limits<double>::infinity() : std::ldexp(view.finest_m, level);
}

bool is_seen(const Sight& sight, const Bounds& bounds) {
  constexpr double kLowSun = 1e-3;
  const double shadow_m = dot(sight.to_sun, sight.to_sun) > 0
                              ? std::clamp((bounds.high_m - sight.lowest_m) / std::max(sight.to_sun.z, kLowSun), 0.0,
                                           sight.longest_shadow_m)
                              : 0;
  return std::ranges::none_of(sight.sides, [&](const Sight::Plane& side) {
    const Vec3 n = side.normal;
    const Vec3 nearest{n.x > 0 ? bounds.plan.min.x : bounds.plan.max.x, n.y > 0 ? bounds.plan.min.y : bounds.plan.max.y,
                       n.z > 0 ? bounds.low_m : bounds.high_m};
    return dot(n, nearest) - std::max(shadow_m * dot(n, sight.to_sun), 0.0) > side.offset_m;
  });
}

double distance_m(const View& view, const Bounds& bounds) {
  double nearest_m = distance_m(bounds, view.eye);
  for (const Bounds& eyes : view.more_eyes) nearest_m = std::min(nearest_m, distance_m(bounds, eyes));
  return nearest_m;
}

int level_for(const View& view, const Bounds& bounds) {
  assert(view.focal_px > 0 && view.pixel_error > 0 && view.finest_m > 0);
  double error_rad = view.pixel_error / view.focal_px;
  if (view.sight && view.sight->unseen_rad > error_rad && !is_seen(*view.sight, bounds))
    error_rad = view.sight->unseen_rad;
  const double most_m = error_rad * distance_m(view, bounds);
  int level = 0;
  while (tolerance_m_of(view, level + 1) <= most_m) ++level;
  return level;
}

double pixels_of(const View& view, double error_m, const Bounds& bounds) {
  const double away_m = distance_m(view, bounds);
  if (view.pixel_error * away_m < view.finest_m * view.focal_px) return 0;
  return error_m / away_m * view.focal_px;
}

}  // namespace citykiln::bake
