#include "preview/clouds/clouds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/clouds/cloud_paths.h"

namespace citykiln::preview {
namespace {

// The detail of clouds in mirrors: a quarter of a degree.
constexpr double kMirrored_rad = 0.004;
// An eye that moves farther sees other sides of clouds.
constexpr double kSameView_m = 25;

}  // namespace

Clouds::Clouds(std::span<const sky::CloudLayer> layers, const sky::SkyModel& model, Vec3 eye, double pixel_rad,
               CloudMethod method, int threads)
    : model_(model),
      field_(layers, light_on_clouds(model), eye, pixel_rad),
      shadow_(field_, field_.light().to_sun, in_plan(eye), threads),
      dome_(field_, model, eye, threads),
      panorama_(field_, eye, pixel_rad),
      mirrored_(field_, eye, std::max(kMirrored_rad, pixel_rad)),
      method_(method) {}

CloudPath Clouds::seen(Vec3 from, Vec3 direction, double distance_m, bool is_camera) const {
  if (method_ == CloudMethod::kPaths)
    return cloud_path(field_, from, direction, distance_m, kMostScatterings, RayChance(from, direction));
  if (std::isinf(distance_m)) {
    const bool is_near = length(from - panorama_.eye()) < kSameView_m;
    if (is_camera && is_near) {
      if (const auto path = panorama_.along(from, direction)) return *path;
    } else if (!is_camera) {
      if (const auto path = mirrored_.along(from, direction)) return *path;
    }
  }
  return field_.along(from, direction, distance_m);
}

CloudVeil Clouds::falling(Vec3 from, Vec3 direction) const {
  if (const auto veil = dome_.along(from, direction)) return *veil;
  const CloudPath path = field_.along(from, direction, std::numeric_limits<double>::infinity());
  return path.passed < 1 ? veil_of(path, sky::air(model_, direction, path.distance_m)) : CloudVeil{};
}

double Clouds::sun_passed(Vec3 from) const {
  if (const auto passed = shadow_.passed(from)) return *passed;
  return field_.sun_passed(from);
}

}  // namespace citykiln::preview
