#include "compiler/buildings/styles/paint_colour.h"

#include <algorithm>
#include <cassert>

namespace citykiln::buildings {
namespace {

using materials::Material;

LinearRgb base_of(Material material) {
  const auto& base = values_of(material).base_colour;
  return {base[0], base[1], base[2]};
}

bool can_show(Material material, const LinearRgb& paint) {
  return std::ranges::equal(paint, base_of(material), std::less_equal());
}

}  // namespace

LinearRgb paint_reflectance(const map::Srgb& colour) {
  LinearRgb linear{};
  for (std::size_t i = 0; i < 3; ++i) linear[i] = materials::linear_of_srgb(colour[i]);
  // luminance (Rec. 709)
  const double grey = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  for (double& c : linear) c = 0.04 + 0.72 * (0.75 * c + 0.25 * grey);
  return linear;
}

Material tintable_material(const LinearRgb& paint, std::initializer_list<Material> choice) {
  assert(choice.size() > 0);
  const Material first = *choice.begin();
  if (first == Material::kGlassFacade || first == Material::kGlass) return first;
  const auto found = std::ranges::find_if(choice, [&](Material material) { return can_show(material, paint); });
  return found != choice.end() ? *found : *(choice.end() - 1);
}

materials::Tint tint_of(const LinearRgb& share) {
  materials::Tint tint = materials::kNoTint;
  for (std::size_t i = 0; i < 3; ++i) tint[i] = static_cast<std::uint8_t>(std::clamp(share[i], 0.0, 1.0) * 255 + 0.5);
  return tint;
}

materials::Tint tint_towards(Material material, const LinearRgb& paint) {
  const LinearRgb base = base_of(material);
  return tint_of({paint[0] / base[0], paint[1] / base[1], paint[2] / base[2]});
}

}  // namespace citykiln::buildings
