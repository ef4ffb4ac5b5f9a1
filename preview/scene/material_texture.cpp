#include "preview/scene/material_texture.h"

#include <cassert>
#include <cmath>

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

bool MaterialTexture::is_there(Vec2 at_m) const {
  assert(has_holes());
  const auto side = static_cast<std::int64_t>(texture_->colour.columns);
  const auto opacity = [&](std::int64_t column, std::int64_t row) -> double {
    const std::int64_t c = (column % side + side) % side, r = (row % side + side) % side;
    return texture_->opacity[static_cast<std::size_t>(r * side + c)];
  };
  const double x = at_m.x / texture_->colour.texel_m - 0.5, y = at_m.y / texture_->colour.texel_m - 0.5;
  const double left = std::floor(x), top = std::floor(y), u = x - left, v = y - top;
  const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(top);
  const double above = opacity(column, row) * (1 - u) + opacity(column + 1, row) * u;
  const double below = opacity(column, row + 1) * (1 - u) + opacity(column + 1, row + 1) * u;
  return above * (1 - v) + below * v >= 127.5;
}

Vec3 MaterialTexture::normal(const TextureFootprint& footprint) const {
  if (!normal_) return {0, 0, 1};
  const auto [u, v, out] = normal_->mean(footprint);
  return unit(Vec3{u, v, out});
}

}  // namespace citykiln::preview
