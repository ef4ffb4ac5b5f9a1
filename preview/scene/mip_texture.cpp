#include "preview/scene/mip_texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/materials/material.h"

namespace citykiln::preview {
namespace {

using Rgb3 = std::array<double, 3>;

template <typename Of>
std::array<float, 256> byte_table(Of of) {
  std::array<float, 256> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = of(static_cast<std::uint8_t>(i));
  return all;
}

// The values of a texel's bytes.
const std::array<float, 256>& values_of(TexelMeaning texels) {
  static const std::array<float, 256> colours = byte_table(materials::linear_of_srgb);
  // flat parts of a normal map are exactly flat, as if there were none: zero lies between two bytes
  static const std::array<float, 256> normals =
      byte_table([](std::uint8_t byte) { return byte == 128 ? 0 : static_cast<float>(byte) / 127.5f - 1; });
  static const std::array<float, 256> numbers =
      byte_table([](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
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
  levels_.push_back(blank_level(image.columns, image.rows));
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

// A level whose texels are not set.
MipTexture::Level MipTexture::blank_level(std::size_t columns, std::size_t rows) const {
  const auto per_m = [&](std::size_t count, std::uint32_t side) {
    return static_cast<double>(count) / (side * static_cast<double>(image_->texel_m));
  };
  return {columns, rows, {per_m(columns, image_->columns), per_m(rows, image_->rows)}, {}};
}

MipTexture::Level MipTexture::halved(const Level& level) const {
  Level half = blank_level(std::max<std::size_t>(1, level.columns / 2), std::max<std::size_t>(1, level.rows / 2));
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

// A place in texels of the level. Whole turns of a repeated side are left out.
double MipTexture::Side::at(double at_m) const {
  const double texels = at_m * texels_per_m, size = static_cast<double>(count);
  return repeats ? texels - std::floor(texels / size) * size : texels;
}

// The texel that shows a place; the outermost ones continue a side that does not repeat.
std::size_t MipTexture::Side::texel(double at) const {
  const double low = static_cast<double>(first), size = static_cast<double>(count), texel = std::floor(at);
  if (repeats) return static_cast<std::size_t>(texel < 0 ? texel + size : texel >= size ? texel - size : texel);
  return static_cast<std::size_t>(std::clamp(texel, low, low + size - 1));
}

MipTexture::Window MipTexture::window(std::size_t number, const TexelRectangle* part) const {
  const Level& level = levels_[number];
  Window all{level,
             {0, level.columns, level.texels_per_m.x, sides_ == WrapMode::kRepeat},
             {0, level.rows, level.texels_per_m.y, true}};
  if (part == nullptr) return all;
  const auto only = [&](Side& side, std::size_t first, std::size_t last) {
    const std::size_t most = side.count - 1, begin = std::min(first >> number, most);
    side = {begin, std::min(last >> number, most) - begin + 1, side.texels_per_m, false};
  };
  only(all.across, part->left, part->right), only(all.down, part->top, part->bottom);
  return all;
}

// Bilinear interpolation between the centres of four texels.
std::array<double, 3> MipTexture::smooth(const Window& window, Vec2 at) const {
  const auto& [level, across, down] = window;
  const double x = across.at(at.x) - 0.5, y = down.at(at.y) - 0.5;
  const double left = std::floor(x), low = std::floor(y), right = x - left, up = y - low;
  const std::size_t here = across.texel(left), next = across.texel(left + 1);
  const std::size_t row = down.texel(low), above = down.texel(low + 1);
  Rgb3 sum{};
  add(sum, texel(level, here, row), (1 - right) * (1 - up));
  add(sum, texel(level, next, row), right * (1 - up));
  add(sum, texel(level, here, above), (1 - right) * up);
  add(sum, texel(level, next, above), right * up);
  return sum;
}

std::array<double, 3> MipTexture::nearest(Vec2 at, double across_m, const TexelRectangle* part) const {
  const double texels = std::min(across_m / image_->texel_m, 1e9);
  const auto wanted = texels > 1 ? static_cast<std::size_t>(std::ilogb(texels)) : 0;
  const auto& [level, across, down] = window(std::min(wanted, levels_.size() - 1), part);
  const Texel found = texel(level, across.texel(across.at(at.x)), down.texel(down.at(at.y)));
  return {found[0], found[1], found[2]};
}

// Interpolates between the two levels whose texel sizes are nearest.
std::array<double, 3> MipTexture::disk(Vec2 at, double across_m, const TexelRectangle* part) const {
  const double last = static_cast<double>(levels_.size() - 1);
  const double fine = std::clamp(std::log2(std::max(across_m / image_->texel_m, 1.0)), 0.0, last);
  const auto level = static_cast<std::size_t>(fine);
  const double coarser = fine - static_cast<double>(level);
  Rgb3 sum{};
  add(sum, smooth(window(level, part), at), 1 - coarser);
  if (coarser > 0) add(sum, smooth(window(level + 1, part), at), coarser);
  return sum;
}

std::array<double, 3> MipTexture::mean(const TextureFootprint& footprint) const { return mean(footprint, nullptr); }

std::array<double, 3> MipTexture::mean(const TextureFootprint& footprint, const TexelRectangle& part) const {
  return mean(footprint, &part);
}

std::array<double, 3> MipTexture::mean(const TextureFootprint& footprint, const TexelRectangle* part) const {
  constexpr int kMostDisks = 16;
  const double half_m = length(footprint.along);
  if (!std::isfinite(half_m) || !std::isfinite(footprint.across_m) ||
      !std::isfinite(footprint.centre.x + footprint.centre.y))
    return smooth(window(levels_.size() - 1, part), {});
  if (footprint.is_rough) return nearest(footprint.centre, footprint.across_m, part);
  const double least_m = std::max(footprint.across_m, image_->texel_m);
  const int disks = static_cast<int>(std::clamp(std::ceil(2 * half_m / least_m), 1.0, 1.0 * kMostDisks));
  const double across_m = std::max(footprint.across_m, 2 * half_m / disks);
  Rgb3 sum{};
  for (int i = 0; i < disks; ++i)
    add(sum, disk(footprint.centre + footprint.along * ((2.0 * i + 1) / disks - 1), across_m, part), 1.0 / disks);
  return sum;
}

}  // namespace citykiln::preview
