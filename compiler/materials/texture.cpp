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

// Colours of one share of the second colour, and steps of this share: together they fit a palette of 256.
constexpr int kColours = 26, kAccentSteps = 8;
// Grey levels of roughness.
constexpr int kRoughnessSteps = 16;
// Quantisation of slopes in each direction: 15 by 15 normals fit a palette of 256. Water needs finer steps.
constexpr int kSlopeSteps = 7, kWaterSlopeSteps = 100;
constexpr std::uint32_t kMaxNormalsSide_px = 256, kMaxBarkNormalsSide_px = 128;

struct Row {
  Material material;
  TexturePattern pattern;
  double side_m;
  std::uint32_t side_px;
  double contrast, warmth, relief_m;
  Rgb accent;
  double roughness;
};

constexpr Row kTextureRows[] = {
#define TEXTURE(material, pattern, side_m, side_px, contrast, warmth, relief_m, red, green, blue, roughness) \
  {Material::material, TexturePattern::pattern, side_m,   side_px, contrast, warmth,                         \
   relief_m,           {red, green, blue},      roughness},
#include "compiler/materials/texture_table.inc"
#undef TEXTURE
};

const Row* row_of(Material material) {
  const auto row = std::ranges::find(kTextureRows, material, &Row::material);
  return row == std::end(kTextureRows) ? nullptr : &*row;
}

using Palette = std::array<Rgb, kColours * kAccentSteps>;

// Colours from dark to light, for each share of the second colour.
Palette palette_of(const Row& row) {
  Palette palette;
  const auto& base = values_of(row.material).base_colour;
  for (int k = 0; k < kColours * kAccentSteps; ++k) {
    const double share = k / kColours / (kAccentSteps - 1.0), tone = (k % kColours + 0.5) * 2 / kColours - 1;
    const double light = 1 + row.contrast * tone;
    const Rgb hue = {1 + row.warmth * tone, 1, 1 - row.warmth * tone};
    for (std::size_t c = 0; c < 3; ++c)
      palette[static_cast<std::size_t>(k)][c] = (base[c] * hue[c] * (1 - share) + row.accent[c] * share) * light;
  }
  return palette;
}

std::size_t step_of(float share, int steps) {
  return static_cast<std::size_t>(std::clamp(share * static_cast<float>(steps), 0.0f, static_cast<float>(steps - 1)));
}

// The number of each texel's colour in the palette.
std::vector<std::uint8_t> palette_numbers(const Row& row, const PatternFields& fields) {
  const bool has_accent = row.accent != Rgb{} && !fields.accent.values.empty();
  std::vector<std::uint8_t> numbers(fields.tone.values.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t share = has_accent ? step_of(fields.accent.values[i], kAccentSteps) : 0;
    numbers[i] = static_cast<std::uint8_t>(share * kColours + step_of((fields.tone.values[i] + 1) / 2, kColours));
  }
  return numbers;
}

TextureImage colour_image(const Row& row, const PatternFields& fields) {
  const Palette palette = palette_of(row);
  const std::vector<std::uint8_t> numbers = palette_numbers(row, fields);
  std::array<std::size_t, kColours * kAccentSteps> counts{};
  for (const std::uint8_t number : numbers) ++counts[number];
  Rgb mean{};
  for (std::size_t i = 0; i < palette.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      mean[c] += palette[i][c] * static_cast<double>(counts[i]) / static_cast<double>(numbers.size());
  const auto& base = values_of(row.material).base_colour;
  std::array<TextureImage::Texel, kColours * kAccentSteps> texels;
  // 3 % lighter than the material, so that colour_factor() stays below 1 after rounding
  for (std::size_t i = 0; i < palette.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) texels[i][c] = srgb_of_linear(palette[i][c] * 1.03 * base[c] / mean[c]);
  TextureImage image{row.side_m / row.side_px, row.side_px, row.side_px, {}};
  image.texels.reserve(numbers.size());
  for (const std::uint8_t number : numbers) image.texels.push_back(texels[number]);
  return image;
}

// Raised places are smoother where the pattern does not say: they are worn.
TextureImage surface_image(const Row& row, const PatternFields& fields) {
  const bool is_by_relief = fields.rough.values.empty();
  const std::uint32_t px = std::min(row.side_px, kMaxNormalsSide_px);
  const Field rough = downsampled(is_by_relief ? fields.relief : fields.rough, px);
  const double own = values_of(row.material).roughness, metallic = values_of(row.material).metallic;
  TextureImage image{row.side_m / px, px, px, {}};
  image.texels.reserve(rough.values.size());
  for (const float value : rough.values) {
    const double tone = std::clamp(is_by_relief ? -value / 2.0 : 1.0 * value, -1.0, 1.0);
    const double stepped = std::floor((tone + 1) / 2 * (kRoughnessSteps - 1) + 0.5) * 2 / (kRoughnessSteps - 1) - 1;
    const double roughness = std::clamp(own + row.roughness * stepped, 0.05, 1.0);
    image.texels.push_back(
        {255, static_cast<std::uint8_t>(roughness * 255 + 0.5), static_cast<std::uint8_t>(metallic * 255 + 0.5)});
  }
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
  return row != nullptr && row->pattern >= TexturePattern::kBars && row->pattern <= TexturePattern::kChainLink;
}

bool has_normals(Material material, double tolerance_m) {
  const Row* row = row_of(material);
  return has_texture(material, tolerance_m) && row->relief_m > 0 &&
         (has_detail(Detail::kGroundNormals, tolerance_m) || row->pattern == TexturePattern::kWaves);
}

bool has_no_units(Material material) {
  using enum TexturePattern;
  constexpr TexturePattern kWithoutUnits[] = {kBlades, kTufts, kLitter,    kMottled, kGrains,      kStones, kCrags,
                                              kRender, kCast,  kGravelBed, kAsphalt, kWornAsphalt, kRipples};
  const Row* row = row_of(material);
  return row != nullptr && std::ranges::find(kWithoutUnits, row->pattern) != std::end(kWithoutUnits);
}

bool runs_along_lanes(Material material) {
  const Row* row = row_of(material);
  return row != nullptr && row->pattern == TexturePattern::kLanes;
}

double texture_side_m(Material material) {
  const Row* row = row_of(material);
  return row == nullptr ? 0 : row->side_m;
}

bool is_bark(Material material) {
  const Row* row = row_of(material);
  return row != nullptr && is_bark(row->pattern);
}

Texture texture_of(Material material, double tolerance_m, std::uint64_t seed, std::uint32_t scale) {
  assert(has_texture(material, tolerance_m));
  Row row = *row_of(material);
  if (!has_holes(material)) row.side_px *= scale;
  const PatternFields fields = generate_pattern(row.pattern, row.side_px, key_of(material, seed));
  Texture texture{material, {}, {}};
  for (const float opacity : fields.opacity.values)
    texture.opacity.push_back(static_cast<std::uint8_t>(opacity * 255 + 0.5f));
  if (row.contrast > 0) texture.colour = colour_image(row, fields);
  if (has_normals(material, tolerance_m))
    texture.normal = normal_image(
        row, downsampled(fields.relief,
                         std::min(row.side_px, is_bark(row.pattern) ? kMaxBarkNormalsSide_px : kMaxNormalsSide_px)));
  if (row.roughness > 0 && has_normals(material, tolerance_m)) texture.surface = surface_image(row, fields);
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
