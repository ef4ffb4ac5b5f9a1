// A point of a surface with all that decides how it scatters light.
#pragma once

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// A point of a surface, with normals in the world's frame.
struct SurfacePoint {
  Vec3 geometric_normal{};  ///< Unit, towards the ray's origin.
  Vec3 shading_normal{};    ///< Unit, interpolated, on the same side.
  Rgb albedo{};             ///< Linear: the colour of material or image, times tint.
  float roughness = 1;      ///< glTF's roughness: the square root of the microfacets' alpha.
  float metallic = 0;
  float f0 = 0.04f;         ///< Reflectance at normal incidence of the part that is not metal.
  double translucency = 0;  ///< Light that passes a leaf as a share of the light that it reflects.
};

}  // namespace citykiln::preview
