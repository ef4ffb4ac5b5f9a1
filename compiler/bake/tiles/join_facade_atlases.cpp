#include "compiler/bake/tiles/join_facade_atlases.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/materials/material.h"

namespace citykiln::bake {
namespace {

using impostor::Atlas;
using materials::TextureImage;

// Returns the mean of up to four texels: of colours in linear light if `is_light`, else of numbers.
TextureImage::Texel mean(std::span<const TextureImage::Texel> texels, bool is_light) {
  TextureImage::Texel mean{};
  for (std::size_t c = 0; c < mean.size(); ++c) {
    double sum = 0;
    for (const TextureImage::Texel& texel : texels) sum += is_light ? materials::linear_of_srgb(texel[c]) : texel[c];
    sum /= static_cast<double>(texels.size());
    mean[c] = is_light ? materials::srgb_of_linear(sum) : static_cast<std::uint8_t>(sum + 0.5);
  }
  return mean;
}

TextureImage halved(const TextureImage& image, bool is_light) {
  TextureImage half{2 * image.texel_m, (image.columns + 1) / 2, (image.rows + 1) / 2, {}};
  for (std::size_t row = 0; row < half.rows; ++row)
    for (std::size_t column = 0; column < half.columns; ++column) {
      std::array<TextureImage::Texel, 4> four{};
      std::size_t count = 0;
      for (std::size_t y = 2 * row; y < std::min<std::size_t>(2 * row + 2, image.rows); ++y)
        for (std::size_t x = 2 * column; x < std::min<std::size_t>(2 * column + 2, image.columns); ++x)
          four[count++] = image.texels[y * image.columns + x];
      half.texels.push_back(mean(std::span(four).first(count), is_light));
    }
  return half;
}

Atlas halved(const Atlas& atlas) {
  const auto if_any = [](const TextureImage& image, bool is_light) {
    return image.texels.empty() ? TextureImage{} : halved(image, is_light);
  };
  return {halved(atlas.colour, true), halved(atlas.surface, false), if_any(atlas.emission, true),
          if_any(atlas.normal, false)};
}

// The first texel of each atlas, and the size of the joined one.
struct FacadeLayout {
  std::vector<std::array<std::uint64_t, 2>> firsts;  // column, row
  std::uint64_t columns = 0, rows = 0;

  bool fits() const {
    return std::max(columns, rows) <= materials::kMaxImageSide_px && columns * rows <= materials::kMaxImageTexels;
  }
};

FacadeLayout layout_of(std::span<const Atlas> atlases) {
  FacadeLayout layout;
  std::uint64_t left = 0, row = 0;
  for (const Atlas& atlas : atlases) {
    const TextureImage& colour = atlas.colour;
    if (row + colour.rows > materials::kMaxImageSide_px) left = layout.columns, row = 0;
    layout.firsts.push_back({left, row});
    row += colour.rows;
    layout.columns = std::max(layout.columns, left + colour.columns), layout.rows = std::max(layout.rows, row);
  }
  return layout;
}

void draw_facades(const TextureImage& image, std::array<std::uint64_t, 2> first, TextureImage& joined) {
  for (std::size_t row = 0; row < image.rows; ++row)
    std::copy_n(image.texels.begin() + static_cast<std::ptrdiff_t>(row * image.columns), image.columns,
                joined.texels.begin() + static_cast<std::ptrdiff_t>((first[1] + row) * joined.columns + first[0]));
}

TextureImage blank(double texel_m, const FacadeLayout& layout, TextureImage::Texel texel = {}) {
  return {texel_m, static_cast<std::uint32_t>(layout.columns), static_cast<std::uint32_t>(layout.rows),
          std::vector<TextureImage::Texel>(layout.columns * layout.rows, texel)};
}

// An empty atlas with the channels that any of the atlases has.
Atlas blank_like(std::span<const Atlas> atlases, double texel_m, const FacadeLayout& layout) {
  const auto any_has = [&](TextureImage Atlas::*image) {
    return std::ranges::any_of(atlases, [&](const Atlas& atlas) { return !(atlas.*image).texels.empty(); });
  };
  constexpr TextureImage::Texel kFlat{128, 128, 255};
  Atlas atlas{blank(texel_m, layout), blank(texel_m, layout), {}, {}};
  if (any_has(&Atlas::emission)) atlas.emission = blank(texel_m, layout);
  if (any_has(&Atlas::normal)) atlas.normal = blank(texel_m, layout, kFlat);
  return atlas;
}

double finest_texel_m(std::span<const Atlas> atlases) {
  double finest_m = 0;
  for (const Atlas& atlas : atlases)
    if (!atlas.colour.texels.empty())
      finest_m = finest_m > 0 ? std::min(finest_m, atlas.colour.texel_m) : atlas.colour.texel_m;
  return finest_m;
}

}  // namespace

JoinedFacadeAtlases join_facade_atlases(std::span<const Atlas* const> atlases) {
  assert(std::ranges::none_of(atlases, [](const Atlas* atlas) { return atlas == nullptr; }));
  std::vector<Atlas> all;
  for (const Atlas* atlas : atlases) all.push_back(*atlas);
  JoinedFacadeAtlases joined{{}, std::vector<JoinedFacadeAtlases::Place>(all.size())};
  const auto finest_m = finest_texel_m(all);
  if (!(finest_m > 0)) return joined;
  // texel sizes in metres before any halving: offsets in metres do not change with it
  std::vector<double> own_m;
  for (const Atlas& atlas : all) own_m.push_back(atlas.colour.texel_m);
  double texel_m = finest_m;
  FacadeLayout layout = layout_of(all);
  for (; !layout.fits(); layout = layout_of(all), texel_m *= 2)
    for (Atlas& atlas : all) atlas = halved(atlas);
  joined.atlas = blank_like(all, texel_m, layout);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].colour.texels.empty()) continue;
    draw_facades(all[i].colour, layout.firsts[i], joined.atlas.colour);
    draw_facades(all[i].surface, layout.firsts[i], joined.atlas.surface);
    draw_facades(all[i].emission, layout.firsts[i], joined.atlas.emission);
    draw_facades(all[i].normal, layout.firsts[i], joined.atlas.normal);
    const auto& [column, row] = layout.firsts[i];
    joined.places[i] = {{static_cast<double>(column) * texel_m, static_cast<double>(row) * texel_m},
                        finest_m / own_m[i]};
  }
  return joined;
}

}  // namespace citykiln::bake
