// An environment map: a panorama of the light around a scene.
#pragma once

#include <vector>

namespace citykiln::preview {

/// Radiance by direction in equirectangular projection, row by row from the zenith to the nadir. The map is seen from
/// inside: the middle of a row is east, and north is left of it, towards smaller columns. Radiance has the scale of the
/// file; exposure is not applied.
struct EnvironmentMap {
  int width = 0, height = 0;
  std::vector<float> rgb;  ///< 3 a pixel, linear with the primaries of sRGB, finite, at least 0.
};

}  // namespace citykiln::preview
