#include "preview/scene/material_texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/materials/noise.h"

namespace citykiln::preview {
namespace {

// Brightness of patterns with units over some metres, as walls and pavements have it from weather and use.
constexpr double kVariedWave_m = 3.7, kVariedShare = 0.09;

// @param across_m  The width of the footprint. From one wavelength on the factor is 1.
double varied(Vec2 at_m, double across_m) {
  const double shown = std::clamp(1 - across_m / kVariedWave_m, 0.0, 1.0);
  return 1 + kVariedShare * shown *
                 (0.6 * materials::noise_at(at_m, kVariedWave_m, 1) + 0.4 * materials::noise_at(at_m, 1.1, 2));
}

}  // namespace

MaterialTexture::MaterialTexture(const materials::Texture& texture)
    : texture_(&texture), factor_(colour_factor(texture)) {
  const auto& colour = texture.colour;
  if (!colour.texels.empty() && (materials::has_no_units(texture.material) || runs_along_lanes(texture.material)))
    blended_.emplace(colour);
  else if (!colour.texels.empty())
    colour_.emplace(colour, TexelMeaning::kColours, WrapMode::kRepeat);
  if (!texture.normal.texels.empty() && !is_water(texture.material))
    normal_.emplace(texture.normal, TexelMeaning::kNormals, WrapMode::kRepeat);
  if (!texture.surface.texels.empty()) surface_.emplace(texture.surface, TexelMeaning::kNumbers, WrapMode::kRepeat);
}

std::size_t MaterialTexture::bytes() const {
  return (colour_ ? colour_->bytes() : 0) + (normal_ ? normal_->bytes() : 0) + (surface_ ? surface_->bytes() : 0) +
         (blended_ ? blended_->bytes() : 0);
}

// One patch without offset where the texture repeats.
BlendedPatches MaterialTexture::patches(const TextureFootprint& footprint, double period_m) const {
  const Vec2 at = footprint.centre;
  if (!blended_ || !std::isfinite(at.x + at.y)) return {{}, {1, 0, 0}};
  BlendedPatches all = patches_at(at, side_m(*texture_), period_m);
  if (runs_along_lanes(texture_->material))
    for (Vec2& offset : all.offsets_m) offset.x = 0;
  return footprint.is_rough ? largest_only(all) : all;
}

std::array<double, 3> MaterialTexture::colour(const TextureFootprint& footprint, double period_m) const {
  if (!colour_ && !blended_) return factor_;
  std::array<double, 3> mean =
      blended_ ? blended_->mean(footprint, patches(footprint, period_m)) : colour_->mean(footprint);
  const bool varies = !blended_ && !footprint.is_rough && !has_holes() && !is_bark(texture_->material);
  const double light = varies ? varied(footprint.centre, footprint.across_m) : 1;
  for (std::size_t c = 0; c < 3; ++c) mean[c] *= factor_[c] * light;
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

Vec3 MaterialTexture::normal(const TextureFootprint& footprint, double period_m) const {
  if (!normal_) return {0, 0, 1};
  const BlendedPatches blend = patches(footprint, period_m);
  Vec3 sum;
  double squares = 0;
  for (std::size_t i = 0; i < blend.shares.size(); ++i) {
    if (blend.shares[i] <= 0) continue;
    TextureFootprint moved = footprint;
    moved.centre = moved.centre + blend.offsets_m[i];
    const auto [u, v, out] = normal_->mean(moved);
    sum = sum + Vec3{u, v, out} * blend.shares[i];
    squares += blend.shares[i] * blend.shares[i];
  }
  // slopes keep their variance
  const double keep = 1 / std::sqrt(squares);
  return unit(Vec3{sum.x * keep, sum.y * keep, sum.z});
}

double MaterialTexture::roughness(const TextureFootprint& footprint, double period_m) const {
  if (!surface_) return values_of(texture_->material).roughness;
  const BlendedPatches blend = patches(footprint, period_m);
  double sum = 0;
  for (std::size_t i = 0; i < blend.shares.size(); ++i) {
    if (blend.shares[i] <= 0) continue;
    TextureFootprint moved = footprint;
    moved.centre = moved.centre + blend.offsets_m[i];
    sum += blend.shares[i] * surface_->mean(moved)[1];
  }
  return sum;
}

}  // namespace citykiln::preview
