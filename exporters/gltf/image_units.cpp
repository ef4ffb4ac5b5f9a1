#include "exporters/gltf/image_units.h"

#include <cmath>

namespace citykiln::exporters {
namespace {

double width_m(const materials::TextureImage& image) { return image.columns * image.texel_m; }
double height_m(const materials::TextureImage& image) { return image.rows * image.texel_m; }

}  // namespace

bake::Float2 in_image_units(const materials::TextureImage& image, const bake::Float2& uv_m) {
  return {static_cast<float>(uv_m[0] / width_m(image)), static_cast<float>(uv_m[1] / height_m(image))};
}

bake::Float2 in_metres(const materials::TextureImage& image, materials::ColourSource colour_source,
                       const bake::Float2& uv) {
  const double u_m = uv[0] * width_m(image), v_m = uv[1] * height_m(image), step_m = uv_step_m(image);
  if (colour_source == materials::ColourSource::kByMaterial) return {static_cast<float>(u_m), static_cast<float>(v_m)};
  const auto nearest = [&](double m) { return static_cast<float>(std::floor(m / step_m + 0.5) * step_m) + 0.0f; };
  return {nearest(u_m), nearest(v_m)};
}

}  // namespace citykiln::exporters
