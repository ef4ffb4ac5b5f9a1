#include "preview/scene/cutout_texture.h"

#include <cassert>
#include <cmath>

namespace citykiln::preview {
namespace {

constexpr std::size_t kCutoutLevels = 2;

}  // namespace

CutoutTexture::CutoutTexture(const impostor::Cutout& cutout)
    : cutout_(&cutout), colour_(cutout.colour, TexelMeaning::kColours, WrapMode::kClamp, kCutoutLevels) {
  if (!cutout.normal.texels.empty())
    normal_.emplace(cutout.normal, TexelMeaning::kNormals, WrapMode::kClamp, kCutoutLevels);
}

std::size_t CutoutTexture::bytes() const {
  return colour_.bytes() + cutout_->opacity.size() + (normal_ ? normal_->bytes() : 0);
}

double CutoutTexture::opacity(std::int64_t column, std::int64_t row) const {
  const std::int64_t columns = cutout_->colour.columns, rows = cutout_->colour.rows;
  if (column < 0 || row < 0 || column >= columns || row >= rows) return 0;
  return cutout_->opacity[static_cast<std::size_t>(row * columns + column)];
}

bool CutoutTexture::is_there(Vec2 at_m) const {
  const double x = at_m.x / cutout_->colour.texel_m - 0.5, y = at_m.y / cutout_->colour.texel_m - 0.5;
  const double left = std::floor(x), top = std::floor(y), u = x - left, v = y - top;
  const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(top);
  const double above = opacity(column, row) * (1 - u) + opacity(column + 1, row) * u;
  const double below = opacity(column, row + 1) * (1 - u) + opacity(column + 1, row + 1) * u;
  return above * (1 - v) + below * v >= impostor::kAlphaCutoff - 0.5;
}

Vec3 CutoutTexture::normal(const TextureFootprint& footprint) const {
  assert(has_normals());
  const auto [u, v, out] = normal_->mean(footprint);
  return unit(Vec3{u, v, out});
}

}  // namespace citykiln::preview
