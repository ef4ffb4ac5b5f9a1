// A sampled light.
#pragma once

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// Light that may reach a place from a sampled point.
struct LightSample {
  Vec3 direction;         ///< Unit, towards the light.
  double distance_m = 0;  ///< Distance from the place along which nothing may block the light.
  /// The radiance of the light divided by pdf. For a lamp, a point: its intensity divided by distance² and by the
  /// probability with which the lamp was chosen; the same for a line. Multiplied by the cosine and the BSDF it
  /// estimates the reflected light.
  Rgb light{};
  /// Density per steradian. 0 for a lamp, which is a point, and a line: rays cannot hit it, so `light` is its whole
  /// contribution.
  double pdf = 0;
};

}  // namespace citykiln::preview
