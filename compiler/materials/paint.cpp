#include "compiler/materials/paint.h"

#include <algorithm>
#include <cassert>

#include "compiler/materials/material.h"

namespace citykiln::materials {
namespace {

TextureImage::Texel mixed_texel(TextureImage::Texel under, TextureImage::Texel over, double share) {
  if (share <= 0) return under;
  if (share >= 1) return over;
  TextureImage::Texel mix{};
  for (std::size_t i = 0; i < mix.size(); ++i)
    mix[i] = srgb_of_linear(linear_of_srgb(under[i]) * (1 - share) + linear_of_srgb(over[i]) * share);
  return mix;
}

}  // namespace

TextureImage blank_image(double texel_m, std::uint32_t columns, std::uint32_t rows, TextureImage::Texel colour) {
  return {texel_m, columns, rows, std::vector<TextureImage::Texel>(static_cast<std::size_t>(columns) * rows, colour)};
}

void paint(TextureImage& image, ColumnRange columns, const Ring& ring_m, TextureImage::Texel colour) {
  assert(image.texel_m > 0 && image.texels.size() == std::size_t{image.columns} * image.rows);
  columns.end = std::min(columns.end, image.columns);
  const Coverage cover = coverage_of(ring_m, image.texel_m, image.rows, columns);
  for (std::size_t r = 0; r < cover.rows; ++r) {
    const std::size_t row = (cover.first_row + r) % image.rows;
    for (std::size_t c = 0; c < cover.columns; ++c) {
      TextureImage::Texel& texel = image.texels[row * image.columns + cover.first_column + c];
      texel = mixed_texel(texel, colour, cover.share[r * cover.columns + c]);
    }
  }
}

}  // namespace citykiln::materials
