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

// A place on a level in texels, whole turns of a repeated side left out.
double MipTexture::on_level(double at_m, std::uint32_t side, std::size_t count, bool repeats) const {
  const double turns = at_m / (side * static_cast<double>(image_->texel_m)), size = static_cast<double>(count);
  return repeats ? (turns - std::floor(turns)) * size : std::clamp(turns * size, 0.0, size);
}

// Bilinear interpolation between the centres of four texels.
std::array<double, 3> MipTexture::smooth(const Level& level, Vec2 at) const {
  const bool repeats = sides_ == WrapMode::kRepeat;
  const double x = on_level(at.x, image_->columns, level.columns, repeats) - 0.5;
  const double y = on_level(at.y, image_->rows, level.rows, true) - 0.5;
  const double left = std::floor(x), low = std::floor(y), right = x - left, up = y - low;
  const auto wrapped = [](double v, std::size_t count) {
    const auto i = static_cast<std::int64_t>(v), n = static_cast<std::int64_t>(count);
    return static_cast<std::size_t>(i < 0 ? i + n : i >= n ? i - n : i);
  };
  const auto clamped = [](double v, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(count - 1)));
  };
  const std::size_t here = repeats ? wrapped(left, level.columns) : clamped(left, level.columns);
  const std::size_t next = repeats ? wrapped(left + 1, level.columns) : clamped(left + 1, level.columns);
  const std::size_t row = wrapped(low, level.rows), above = wrapped(low + 1, level.rows);
  Rgb3 sum{};
  add(sum, texel(level, here, row), (1 - right) * (1 - up));
  add(sum, texel(level, next, row), right * (1 - up));
  add(sum, texel(level, here, above), (1 - right) * up);
  add(sum, texel(level, next, above), right * up);
  return sum;
}

std::array<double, 3> MipTexture::nearest(Vec2 at, double across_m) const {
  const double texels = std::min(across_m / image_->texel_m, 1e9);
  const auto wanted = texels > 1 ? static_cast<std::size_t>(std::ilogb(texels)) : 0;
  const Level& level = levels_[std::min(wanted, levels_.size() - 1)];
  const auto place = [](double v, std::size_t count) { return std::min(static_cast<std::size_t>(v), count - 1); };
  const Texel found =
      texel(level, place(on_level(at.x, image_->columns, level.columns, sides_ == WrapMode::kRepeat), level.columns),
            place(on_level(at.y, image_->rows, level.rows, true), level.rows));
  return {found[0], found[1], found[2]};
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
  if (footprint.is_rough) return nearest(footprint.centre, footprint.across_m);
  const double least_m = std::max(footprint.across_m, image_->texel_m);
  const int disks = static_cast<int>(std::clamp(std::ceil(2 * half_m / least_m), 1.0, 1.0 * kMostDisks));
  const double across_m = std::max(footprint.across_m, 2 * half_m / disks);
  Rgb3 sum{};
  for (int i = 0; i < disks; ++i)
    add(sum, disk(footprint.centre + footprint.along * ((2.0 * i + 1) / disks - 1), across_m), 1.0 / disks);
  return sum;
}

}  // namespace citykiln::preview
