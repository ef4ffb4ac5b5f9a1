#include "preview/scene/mip_texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/materials/material.h"

namespace citykiln::preview {
namespace {

using Rgb3 = std::array<double, 3>;

template <typename Of>
std::array<float, 256> table(Of of) {
  std::array<float, 256> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = of(static_cast<std::uint8_t>(i));
  return all;
}

// The values of a texel's bytes.
const std::array<float, 256>& values_of(TexelMeaning texels) {
  static const std::array<float, 256> colours = table(materials::linear_of_srgb);
  static const std::array<float, 256> normals =
      table([](std::uint8_t byte) { return static_cast<float>(byte) / 127.5f - 1; });
  static const std::array<float, 256> numbers = table([](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
  if (texels == TexelMeaning::kNumbers) return numbers;
  return texels == TexelMeaning::kColours ? colours : normals;
}

template <typename Colour>
void add(Rgb3& sum, const Colour& colour, double weight) {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * colour[c];
}

// The texels that a coarser one averages, from `first` on, and their weights.
struct Shares {
  std::size_t first;
  std::array<double, 4> of{};
};

Shares shares(std::size_t i, std::size_t fine, std::size_t coarse) {
  // the last edge is exactly that of the last texel
  const auto edge = [&](std::size_t n) { return static_cast<double>(n * fine) / static_cast<double>(coarse); };
  const double begin = edge(i), end = edge(i + 1);
  Shares all{i * fine / coarse, {}};
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto low = static_cast<double>(all.first + k);
    all.of[k] = std::max(0.0, std::min(end, low + 1) - std::max(begin, low)) / (end - begin);
  }
  return all;
}

}  // namespace

std::size_t MipTexture::bytes() const {
  std::size_t bytes = image_->texels.size() * sizeof(materials::TextureImage::Texel);
  for (const Level& level : levels_) bytes += level.texels.size() * sizeof(Texel);
  return bytes;
}

MipTexture::MipTexture(const materials::TextureImage& image, TexelMeaning texels, WrapMode sides, std::size_t levels)
    : image_(&image), texels_(texels), sides_(sides) {
  assert(image.texels.size() == std::size_t{image.columns} * image.rows && !image.texels.empty() && levels > 0);
  levels_.push_back({image.columns, image.rows, {}});
  while (levels_.size() < levels && (levels_.back().columns > 1 || levels_.back().rows > 1))
    levels_.push_back(halved(levels_.back()));
}

MipTexture::Texel MipTexture::texel(const Level& level, std::size_t column, std::size_t row) const {
  const std::size_t place = row * level.columns + column;
  if (!level.texels.empty()) return level.texels[place];
  const auto& [r, g, b] = image_->texels[place];
  const auto& values = values_of(texels_);
  return {values[r], values[g], values[b]};
}

MipTexture::Level MipTexture::halved(const Level& level) const {
  Level half{std::max<std::size_t>(1, level.columns / 2), std::max<std::size_t>(1, level.rows / 2), {}};
  half.texels.resize(half.columns * half.rows);
  for (std::size_t row = 0; row < half.rows; ++row)
    for (std::size_t column = 0; column < half.columns; ++column) {
      const Shares across = shares(column, level.columns, half.columns), along = shares(row, level.rows, half.rows);
      Rgb3 sum{};
      for (std::size_t y = 0; y < along.of.size(); ++y)
        for (std::size_t x = 0; x < across.of.size(); ++x)
          if (const double share = along.of[y] * across.of[x]; share > 0)
            add(sum, texel(level, across.first + x, along.first + y), share);
      half.texels[row * half.columns + column] = {static_cast<float>(sum[0]), static_cast<float>(sum[1]),
                                                  static_cast<float>(sum[2])};
    }
  return half;
}

// Bilinear interpolation between the centres of four texels.
std::array<double, 3> MipTexture::smooth(const Level& level, Vec2 at) const {
  const double columns = static_cast<double>(level.columns), rows = static_cast<double>(level.rows);
  const double across = at.x / (image_->columns * image_->texel_m), along = at.y / (image_->rows * image_->texel_m);
  const auto repeated = [](double turns, double count) { return (turns - std::floor(turns)) * count + count - 0.5; };
  const double x =
      sides_ == WrapMode::kRepeat ? repeated(across, columns) : std::clamp(across * columns - 0.5, 0.0, columns - 1);
  const double y = repeated(along, rows);
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const double right = x - static_cast<double>(column), up = y - static_cast<double>(row);
  const std::size_t here = column % level.columns;
  const std::size_t next =
      sides_ == WrapMode::kRepeat ? (column + 1) % level.columns : std::min(column + 1, level.columns - 1);
  Rgb3 sum{};
  add(sum, texel(level, here, row % level.rows), (1 - right) * (1 - up));
  add(sum, texel(level, next, row % level.rows), right * (1 - up));
  add(sum, texel(level, here, (row + 1) % level.rows), (1 - right) * up);
  add(sum, texel(level, next, (row + 1) % level.rows), right * up);
  return sum;
}

// Interpolates between the two levels whose texel sizes are nearest.
std::array<double, 3> MipTexture::disk(Vec2 at, double across_m) const {
  const double last = static_cast<double>(levels_.size() - 1);
  const double fine = std::clamp(std::log2(std::max(across_m / image_->texel_m, 1.0)), 0.0, last);
  const auto level = static_cast<std::size_t>(fine);
  const double coarser = fine - static_cast<double>(level);
  Rgb3 sum{};
  add(sum, smooth(levels_[level], at), 1 - coarser);
  if (coarser > 0) add(sum, smooth(levels_[level + 1], at), coarser);
  return sum;
}

std::array<double, 3> MipTexture::mean(const TextureFootprint& footprint) const {
  constexpr int kMostDisks = 16;
  const double half_m = length(footprint.along);
  if (!std::isfinite(half_m) || !std::isfinite(footprint.across_m) ||
      !std::isfinite(footprint.centre.x + footprint.centre.y))
    return smooth(levels_.back(), {});
  const double least_m = std::max(footprint.across_m, image_->texel_m);
  const int disks = static_cast<int>(std::clamp(std::ceil(2 * half_m / least_m), 1.0, 1.0 * kMostDisks));
  const double across_m = std::max(footprint.across_m, 2 * half_m / disks);
  Rgb3 sum{};
  for (int i = 0; i < disks; ++i)
    add(sum, disk(footprint.centre + footprint.along * ((2.0 * i + 1) / disks - 1), across_m), 1.0 / disks);
  return sum;
}

}  // namespace citykiln::preview
