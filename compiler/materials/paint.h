// Paint on a sheet.
#pragma once

#include "compiler/materials/coverage.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::materials {

/// A sheet of one colour.
TextureImage blank_image(double texel_m, std::uint32_t columns, std::uint32_t rows, TextureImage::Texel colour);

/// Paints a polygon over what is there.
///
/// @param columns  Paint stops at their sides, so that strips do not bleed into each other; beyond the sheet it is cut.
/// @param ring_m   TextureImage metres, simple, either way round. Along v the sheet wraps.
///
/// Guarantees: a texel becomes the mix, in linear light, of what it was and the colour, by the share of it that the
/// ring covers (coverage.h): a line thinner than a texel becomes faint, not lost. Later paint lies over earlier. Only
/// + − × ÷: the same bytes on every CPU. Bad input as in coverage.h. O(texels of the ring's box).
void paint(TextureImage& sheet, ColumnRange columns, const Ring& ring_m, TextureImage::Texel colour);

}  // namespace citykiln::materials
