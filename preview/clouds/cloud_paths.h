// Paths of light through clouds: the reference for CloudField.
#pragma once

#include "preview/clouds/cloud_field.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// One sample of the light that a cloud sends along a ray, with all orders of scattering up to `most`.
///
/// Method: distances to droplets by the exact optical depth of the spheres, directions by Henyey and Greenstein's phase
/// function, sunlight gathered at each droplet. No light is absorbed. Unbiased but for orders beyond `most`.
/// @param random  Returns independent numbers in [0, 1).
template <typename Random>
CloudPath cloud_path(const CloudSpheres& spheres, const CloudLight& light, Vec3 from, Vec3 direction, int most,
                     Random random);

/// Where a ray has passed an optical depth; infinite where it leaves the clouds before.
double distance_at_depth(const CloudSpheres& spheres, Vec3 from, Vec3 direction, double optical_depth);

/// A direction by Henyey and Greenstein's phase function around another.
Vec3 scattered(Vec3 direction, double g, UnitPair chance);

// ---- implementation of the template ----

template <typename Random>
CloudPath cloud_path(const CloudSpheres& spheres, const CloudLight& light, Vec3 from, Vec3 direction, int most,
                     Random random) {
  CloudPath path;
  for (int order = 0; order < most; ++order) {
    const double distance_m = distance_at_depth(spheres, from, direction, -std::log(1 - random()));
    if (!std::isfinite(distance_m)) {
      if (order > 0) path.added = path.added + (direction.z >= 0 ? light.sky : light.ground);
      return path;
    }
    path.passed = 0;
    if (order == 0) path.distance_m = distance_m;
    from = from + direction * distance_m;
    const double reaches = std::exp(-spheres.optical_depth(from, light.to_sun));
    path.added =
        path.added + light.sun * (reaches * henyey_greenstein(dot(direction, light.to_sun), kDropletAsymmetry));
    const double u = random();
    direction = scattered(direction, kDropletAsymmetry, {u, random()});
  }
  return path;
}

}  // namespace citykiln::preview
