#include "preview/scene/tile_blending.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "compiler/materials/material.h"

namespace citykiln::preview {
namespace {

using Channel3 = std::array<double, 3>;
using materials::TextureImage;

// Bytes from 0 to 255 stand for so many standard deviations on each side.
constexpr double kDeviations = 3;

double deviate_of(double byte) { return (byte / 255 - 0.5) * 2 * kDeviations; }

std::uint64_t mixed_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::int64_t whole_modulo(std::int64_t a, std::int64_t b) { return (a % b + b) % b; }

// The random offset of a corner of the grid, of `count` rows and twice as many half columns a period.
Vec2 offset_of(std::int64_t a, std::int64_t b, std::int64_t count, double side_m) {
  const auto across = static_cast<std::uint64_t>(whole_modulo(2 * a + b, 2 * count)),
             along = static_cast<std::uint64_t>(whole_modulo(b, count));
  const std::uint64_t bits = mixed_bits(across << 32 | along);
  return {side_m * static_cast<double>(bits & 0xffffffffu) * 0x1p-32,
          side_m * static_cast<double>(bits >> 32) * 0x1p-32};
}

double normal_share_below(double deviate) { return 0.5 * std::erfc(-deviate / std::sqrt(2.0)); }

// The deviate with a share of a normal distribution below it, by bisection.
double deviate_above(double share) {
  double low = -kDeviations, high = kDeviations;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (normal_share_below(middle) < share ? low : high) = middle;
  }
  return (low + high) / 2;
}

// For each value of a channel the share of texels below it, and half of those that have it.
std::array<double, 256> shares_below(const TextureImage& image, std::size_t channel) {
  std::array<double, 256> counts{}, below{};
  for (const TextureImage::Texel& texel : image.texels) counts[texel[channel]] += 1;
  double sum = 0;
  for (std::size_t v = 0; v < counts.size(); ++v) {
    below[v] = (sum + counts[v] / 2) / static_cast<double>(image.texels.size());
    sum += counts[v];
  }
  return below;
}

TextureImage deviates_image(const TextureImage& image) {
  TextureImage out = image;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::array<double, 256> below = shares_below(image, channel);
    std::array<std::uint8_t, 256> byte{};
    for (std::size_t v = 0; v < byte.size(); ++v)
      byte[v] = static_cast<std::uint8_t>(
          std::clamp((deviate_above(below[v]) / (2 * kDeviations) + 0.5) * 255 + 0.5, 0.0, 255.0));
    for (TextureImage::Texel& texel : out.texels) texel[channel] = byte[texel[channel]];
  }
  return out;
}

// The linear colour of each deviate of a channel.
std::array<float, 256> colours_of_deviates(const TextureImage& image, std::size_t channel) {
  const std::array<double, 256> below = shares_below(image, channel);
  std::array<float, 256> colours{};
  std::size_t at = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double share = normal_share_below(deviate_of(static_cast<double>(i)));
    while (at + 1 < below.size() && below[at] < share) ++at;
    const std::size_t before = at == 0 ? 0 : at - 1;
    const double gap = below[at] - below[before],
                 part = gap > 0 ? std::clamp((share - below[before]) / gap, 0.0, 1.0) : 1;
    colours[i] = static_cast<float>((1 - part) * materials::linear_of_srgb(static_cast<std::uint8_t>(before)) +
                                    part * materials::linear_of_srgb(static_cast<std::uint8_t>(at)));
  }
  return colours;
}

float value_in(const std::array<float, 256>& table, double deviate) {
  const double at = std::clamp((deviate / (2 * kDeviations) + 0.5) * 255, 0.0, 255.0);
  const auto low = std::min<std::size_t>(static_cast<std::size_t>(at), 254);
  const auto part = static_cast<float>(at - static_cast<double>(low));
  return table[low] * (1 - part) + table[low + 1] * part;
}

// The mean of a table over normal deviates about each entry, which a mip level no longer shows.
std::array<float, 256> filtered_table(const std::array<float, 256>& table, double deviation) {
  constexpr int kSamples = 8;
  std::array<float, 256> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0, weights = 0;
    for (int k = -kSamples; k <= kSamples; ++k) {
      const double off = 3.0 * k / kSamples, weight = std::exp(-off * off / 2);
      sum += weight * value_in(table, deviate_of(static_cast<double>(i)) + off * deviation), weights += weight;
    }
    out[i] = static_cast<float>(sum / weights);
  }
  return out;
}

// A channel's deviates, averaged over squares of 2 × 2 of the level before.
std::vector<double> halved_deviates(const std::vector<double>& fine, std::size_t side) {
  std::vector<double> half(side * side / 4);
  for (std::size_t row = 0; row < side / 2; ++row)
    for (std::size_t column = 0; column < side / 2; ++column) {
      const std::size_t at = 2 * row * side + 2 * column;
      half[row * side / 2 + column] = (fine[at] + fine[at + 1] + fine[at + side] + fine[at + side + 1]) / 4;
    }
  return half;
}

double variance_of(const std::vector<double>& deviates) {
  double squares = 0;
  for (const double d : deviates) squares += d * d;
  return squares / static_cast<double>(deviates.size());
}

double mean_of_channel(const TextureImage& image, std::size_t channel) {
  double sum = 0;
  for (const TextureImage::Texel& texel : image.texels) sum += materials::linear_of_srgb(texel[channel]);
  return sum / static_cast<double>(image.texels.size());
}

// Scales a table so that its mean over a level's deviates is that of the image; without deviates all of it is the mean.
void keep_mean(std::array<float, 256>& table, const std::vector<double>& deviates, double mean) {
  double sum = 0;
  for (const double d : deviates) sum += value_in(table, d);
  const double share = sum > 0 ? mean * static_cast<double>(deviates.size()) / sum : 0;
  for (float& value : table) value = share > 0 ? static_cast<float>(value * share) : static_cast<float>(mean);
}

}  // namespace

BlendedPatches patches_at(Vec2 at_m, double side_m, double period_m) {
  // an even number, so that half a column more for each row ends where it began
  const auto count = std::max<std::int64_t>(2, 2 * std::llround(1.732 * period_m / side_m));
  const double b = at_m.y * static_cast<double>(count) / period_m,
               a = at_m.x * static_cast<double>(count) / period_m - 0.5 * b;
  const auto column = static_cast<std::int64_t>(std::floor(a)), row = static_cast<std::int64_t>(std::floor(b));
  const double right = a - std::floor(a), up = b - std::floor(b);
  const auto offset = [&](std::int64_t i, std::int64_t j) { return offset_of(column + i, row + j, count, side_m); };
  if (right + up < 1) return {{offset(0, 0), offset(1, 0), offset(0, 1)}, {1 - right - up, right, up}};
  return {{offset(1, 1), offset(0, 1), offset(1, 0)}, {right + up - 1, 1 - right, 1 - up}};
}

BlendedPatches largest_only(const BlendedPatches& patches) {
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(patches.shares) - patches.shares.begin());
  BlendedPatches one{{patches.offsets_m[largest]}, {1, 0, 0}};
  return one;
}

BlendedColours::BlendedColours(const TextureImage& image)
    : deviates_(deviates_image(image)), levels_(deviates_, TexelMeaning::kNumbers, WrapMode::kRepeat) {
  assert(image.columns == image.rows && (image.columns & (image.columns - 1)) == 0);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::array<float, 256> exact = colours_of_deviates(image, channel);
    std::vector<double> deviates;
    for (const TextureImage::Texel& texel : deviates_.texels) deviates.push_back(deviate_of(texel[channel]));
    const double whole = variance_of(deviates);
    std::size_t level = 0;
    for (std::size_t side = image.columns; side >= 1; side /= 2, ++level) {
      if (inverse_.size() <= level) inverse_.emplace_back();
      inverse_[level][channel] =
          level == 0 ? exact : filtered_table(exact, std::sqrt(std::max(0.0, whole - variance_of(deviates))));
      keep_mean(inverse_[level][channel], side > 2 ? deviates : std::vector<double>{}, mean_of_channel(image, channel));
      if (side > 1) deviates = halved_deviates(deviates, side);
    }
  }
}

std::array<double, 3> BlendedColours::colour_of(const Channel3& deviate, double level) const {
  const double fine = std::clamp(level, 0.0, static_cast<double>(inverse_.size() - 1));
  const auto low = static_cast<std::size_t>(fine), high = std::min(low + 1, inverse_.size() - 1);
  Channel3 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = std::lerp(1.0 * value_in(inverse_[low][c], deviate[c]), 1.0 * value_in(inverse_[high][c], deviate[c]),
                          fine - static_cast<double>(low));
  return colour;
}

std::array<double, 3> BlendedColours::mean(const TextureFootprint& footprint, const BlendedPatches& patches) const {
  Channel3 sum{};
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (patches.shares[i] <= 0) continue;
    TextureFootprint moved = footprint;
    moved.centre = moved.centre + patches.offsets_m[i];
    const Channel3 bytes = levels_.mean(moved);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += patches.shares[i] * deviate_of(bytes[c] * 255);
    squares += patches.shares[i] * patches.shares[i];
  }
  for (double& s : sum) s /= std::sqrt(std::max(squares, 1e-9));
  const double across_m = std::max(footprint.across_m, length(footprint.along) / 8);
  return colour_of(sum, std::isfinite(across_m) ? std::log2(std::max(1.0, across_m / deviates_.texel_m)) : 64);
}

std::size_t BlendedColours::bytes() const { return levels_.bytes() + inverse_.size() * sizeof(Table); }

}  // namespace citykiln::preview
