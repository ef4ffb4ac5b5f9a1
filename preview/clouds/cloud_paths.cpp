#include "preview/clouds/cloud_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/surface/microfacet.h"
#include "preview/turn.h"

namespace citykiln::preview {

double distance_at_depth(const CloudSpheres& spheres, Vec3 from, Vec3 direction, double optical_depth) {
  std::vector<SpherePart> parts;
  spheres.parts_of(from, direction, std::numeric_limits<double>::infinity(), parts);
  double left_m = optical_depth / spheres.extinction_per_m(), reached = 0;
  for (const SpherePart& part : parts) {
    const double begin = std::max(part.begin, reached), here_m = std::max(0.0, part.end - begin);
    if (left_m < here_m) return begin + left_m;
    left_m -= here_m, reached = std::max(reached, part.end);
  }
  return std::numeric_limits<double>::infinity();
}

Vec3 scattered(Vec3 direction, double g, UnitPair chance) {
  const double s = (1 - g * g) / (1 - g + 2 * g * chance.u),
               cosine = std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
  const double sine = std::sqrt(1 - cosine * cosine);
  return unit(frame_about(direction).out_of(at_height(on_circle(chance.v) * sine, cosine)));
}

}  // namespace citykiln::preview
