#include "preview/clouds/clouds.h"

#include <limits>

#include "preview/clouds/cloud_paths.h"

namespace citykiln::preview {

Clouds::Clouds(std::span<const sky::CloudLayer> layers, const sky::SkyModel& model, Vec3 eye, double finest_rad,
               CloudMethod method, int threads)
    : model_(model),
      field_(layers, light_on_clouds(model), eye, finest_rad, threads),
      shadow_(field_, field_.light().to_sun, in_plan(eye), threads),
      dome_(field_, model, eye, threads),
      method_(method) {}

CloudPath Clouds::seen(Vec3 from, Vec3 direction, double distance_m) const {
  if (method_ == CloudMethod::kApproximate) return field_.along(from, direction, distance_m);
  return cloud_path(field_, from, direction, distance_m, kMostScatterings, RayChance(from, direction));
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
