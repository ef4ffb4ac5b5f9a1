#include "compiler/materials/texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/materials/texture_pattern.h"

namespace citykiln::materials {
namespace {

using Rgb = std::array<double, 3>;

constexpr int kColours = 16;
// Quantisation of slopes in each direction: 15 by 15 normals fit a palette of 256. Water needs finer steps.
constexpr int kSlopeSteps = 7, kWaterSlopeSteps = 100;
constexpr std::uint32_t kMaxNormalsSide_px = 128;

struct Row {
  Material material;
  TexturePattern pattern;
  double side_m;
  std::uint32_t side_px;
  double contrast, warmth, relief_m;
};

constexpr Row kTextureRows[] = {
#define TEXTURE(material, pattern, side_m, side_px, contrast, warmth, relief_m) \
  {Material::material, TexturePattern::pattern, side_m, side_px, contrast, warmth, relief_m},
#include "compiler/materials/texture_table.inc"
#undef TEXTURE
};

const Row* row_of(Material material) {
  const auto row = std::ranges::find(kTextureRows, material, &Row::material);
  return row == std::end(kTextureRows) ? nullptr : &*row;
}

// Colours from dark to light.
std::array<Rgb, kColours> palette_of(const Row& row) {
  std::array<Rgb, kColours> palette;
  const auto& base = values_of(row.material).base_colour;
  for (int i = 0; i < kColours; ++i) {
    const double tone = (i + 0.5) * 2 / kColours - 1, light = 1 + row.contrast * tone;
    const Rgb hue = {1 + row.warmth * tone, 1, 1 - row.warmth * tone};
    for (std::size_t c = 0; c < 3; ++c) palette[static_cast<std::size_t>(i)][c] = base[c] * light * hue[c];
  }
  return palette;
}

std::size_t colour_at(float tone) {
  return static_cast<std::size_t>(std::clamp((tone + 1) / 2 * kColours, 0.0f, kColours - 1.0f));
}

TextureImage colour_image(const Row& row, const Field& tone) {
  std::array<Rgb, kColours> palette = palette_of(row);
  Rgb mean{};
  for (const float t : tone.values)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += palette[colour_at(t)][c] / static_cast<double>(tone.values.size());
  const auto& base = values_of(row.material).base_colour;
  std::array<TextureImage::Texel, kColours> texels;
  // 3 % lighter than the material, so that colour_factor() stays below 1 after rounding
  for (std::size_t i = 0; i < kColours; ++i)
    for (std::size_t c = 0; c < 3; ++c) texels[i][c] = srgb_of_linear(palette[i][c] * 1.03 * base[c] / mean[c]);
  TextureImage image{row.side_m / tone.side_px, tone.side_px, tone.side_px, {}};
  image.texels.reserve(tone.values.size());
  for (const float t : tone.values) image.texels.push_back(texels[colour_at(t)]);
  return image;
}

// Quantises a slope, clamped to ±most.
double quantised(double slope, double most, int steps) {
  return std::floor(std::clamp(slope / most, -1.0, 1.0) * steps + 0.5) / steps * most;
}

TextureImage::Texel texel_of(double slope_u, double slope_v) {
  const double out = 1 / std::sqrt(1 + slope_u * slope_u + slope_v * slope_v);
  const auto byte = [](double n) { return static_cast<std::uint8_t>((n + 1) / 2 * 255 + 0.5); };
  return {byte(-slope_u * out), byte(slope_v * out), byte(out)};
}

TextureImage normal_image(const Row& row, const Field& relief) {
  const std::uint32_t px = relief.side_px;
  const double texel_m = row.side_m / px;
  const auto slope = [&](float after, float before) { return (after - before) * row.relief_m / (2 * texel_m); };
  const auto slope_u = [&](std::uint32_t c, std::uint32_t r) {
    return slope(relief.at((c + 1) % px, r), relief.at((c + px - 1) % px, r));
  };
  const auto slope_v = [&](std::uint32_t c, std::uint32_t r) {
    return slope(relief.at(c, (r + 1) % px), relief.at(c, (r + px - 1) % px));
  };
  double squares = 0;
  for (std::uint32_t r = 0; r < px; ++r)
    for (std::uint32_t c = 0; c < px; ++c) squares += slope_u(c, r) * slope_u(c, r) + slope_v(c, r) * slope_v(c, r);
  // slopes above 2.2 standard deviations are rare
  const double most = 2.2 * std::sqrt(squares / (2.0 * px * px));
  const int steps = row.pattern == TexturePattern::kWaves ? kWaterSlopeSteps : kSlopeSteps;
  TextureImage image{texel_m, px, px, {}};
  image.texels.reserve(relief.values.size());
  for (std::uint32_t r = 0; r < px; ++r)
    for (std::uint32_t c = 0; c < px; ++c)
      image.texels.push_back(texel_of(quantised(slope_u(c, r), most, steps), quantised(slope_v(c, r), most, steps)));
  return image;
}

std::uint64_t key_of(Material material, std::uint64_t seed) {
  const StableId id{static_cast<std::uint64_t>(material)};
  const RandomSequence draw(seed, id, "texture");
  return std::uint64_t{draw.below(0xffffffffu, 0)} << 32 | draw.below(0xffffffffu, 1);
}

}  // namespace

double side_m(const Texture& texture) {
  const TextureImage& image = texture.colour.texels.empty() ? texture.normal : texture.colour;
  return image.columns * image.texel_m;
}

bool has_texture(Material material, double tolerance_m) {
  if (has_holes(material)) return tolerance_m < tolerances_with(Detail::kFacadeTextures).from_m;
  return row_of(material) != nullptr && has_detail(Detail::kMaterialTextures, tolerance_m);
}

bool has_holes(Material material) {
  const Row* row = row_of(material);
  return row != nullptr && row->pattern == TexturePattern::kBars;
}

bool has_normals(Material material, double tolerance_m) {
  const Row* row = row_of(material);
  return has_texture(material, tolerance_m) && row->relief_m > 0 &&
         (has_detail(Detail::kGroundNormals, tolerance_m) || row->pattern == TexturePattern::kWaves);
}

double texture_side_m(Material material) {
  const Row* row = row_of(material);
  return row == nullptr ? 0 : row->side_m;
}

bool is_bark(Material material) {
  const Row* row = row_of(material);
  return row != nullptr && is_bark(row->pattern);
}

Texture texture_of(Material material, double tolerance_m, std::uint64_t seed) {
  assert(has_texture(material, tolerance_m));
  const Row& row = *row_of(material);
  const PatternFields tones = generate_pattern(row.pattern, row.side_px, key_of(material, seed));
  Texture texture{material, {}, {}};
  for (const float opacity : tones.opacity.values)
    texture.opacity.push_back(static_cast<std::uint8_t>(opacity * 255 + 0.5f));
  if (row.contrast > 0) texture.colour = colour_image(row, tones.tone);
  if (has_normals(material, tolerance_m))
    texture.normal = normal_image(row, downsampled(tones.relief, std::min(row.side_px, kMaxNormalsSide_px)));
  return texture;
}

std::array<double, 3> colour_factor(const Texture& texture) {
  const auto& base = values_of(texture.material).base_colour;
  Rgb factor = {base[0], base[1], base[2]}, mean{};
  const auto& texels = texture.colour.texels;
  if (texels.empty()) return factor;
  std::array<std::array<std::uint32_t, 256>, 3> counts{};
  for (const TextureImage::Texel& texel : texels)
    for (std::size_t c = 0; c < 3; ++c) ++counts[c][texel[c]];
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t value = 0; value < counts[c].size(); ++value)
      mean[c] +=
          counts[c][value] * linear_of_srgb(static_cast<std::uint8_t>(value)) / static_cast<double>(texels.size());
  for (std::size_t c = 0; c < 3; ++c) factor[c] = mean[c] > 0 ? std::min(1.0, factor[c] / mean[c]) : 1;
  return factor;
}

}  // namespace citykiln::materials
