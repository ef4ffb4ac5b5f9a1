// Painting polygons on texture images.
#pragma once

#include "compiler/materials/coverage.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::materials {

/// Returns an image of one colour.
TextureImage blank_image(double texel_m, std::uint32_t columns, std::uint32_t rows, TextureImage::Texel colour);

/// Paints a polygon over an image.
///
/// @param columns  The columns that may change; beyond the image it is clipped.
/// @param ring_m   Image metres, simple, of either orientation. Along v the image wraps around.
///
/// Guarantees: a texel becomes the mix, in linear light, of its colour and the new one by the share that the ring
/// covers (coverage.h), so that lines thinner than a texel become faint instead of vanishing. Only + − × ÷: the same
/// bytes on every CPU. Bad input as for coverage_of(). O(texels of the ring's box).
void paint(TextureImage& image, ColumnRange columns, const Ring& ring_m, TextureImage::Texel colour);

}  // namespace citykiln::materials
