#include "preview/scene/material_texture.h"

namespace citykiln::preview {

MaterialTexture::MaterialTexture(const materials::Texture& texture)
    : texture_(&texture), factor_(colour_factor(texture)) {
  using materials::Material;
  const bool is_water = texture.material == Material::kWater || texture.material == Material::kSea ||
                        texture.material == Material::kPoolWater;
  if (!texture.colour.texels.empty()) colour_.emplace(texture.colour, TexelMeaning::kColours, WrapMode::kRepeat);
  if (!texture.normal.texels.empty() && !is_water)
    normal_.emplace(texture.normal, TexelMeaning::kNormals, WrapMode::kRepeat);
}

std::size_t MaterialTexture::bytes() const {
  return (colour_ ? colour_->bytes() : 0) + (normal_ ? normal_->bytes() : 0);
}

std::array<double, 3> MaterialTexture::colour(const TextureFootprint& footprint) const {
  if (!colour_) return factor_;
  std::array<double, 3> mean = colour_->mean(footprint);
  for (std::size_t c = 0; c < 3; ++c) mean[c] *= factor_[c];
  return mean;
}

Vec3 MaterialTexture::normal(const TextureFootprint& footprint) const {
  if (!normal_) return {0, 0, 1};
  const auto [u, v, out] = normal_->mean(footprint);
  return unit(Vec3{u, v, out});
}

}  // namespace citykiln::preview
