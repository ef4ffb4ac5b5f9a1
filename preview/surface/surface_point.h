// A place on a surface, by what decides how it scatters light.
#pragma once

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// In the world's frame.
struct SurfacePoint {
  Vec3 geometric_normal{};  ///< Unit, towards the ray's origin.
  Vec3 shading_normal{};    ///< Unit, interpolated, on the same side.
  Rgb albedo{};             ///< Linear: the colour of material or image, times tint.
  float roughness = 1;      ///< As in glTF.
  float metallic = 0;
  float f0 = 0.04f;         ///< Reflectance at normal incidence, of what is not metal.
  double translucency = 0;  ///< Light that passes a leaf as a share of the light that it reflects.
};

}  // namespace citykiln::preview
