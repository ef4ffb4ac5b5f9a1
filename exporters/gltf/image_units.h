// Texture coordinates in metres, as a tile has them, and in units of an image's size, as all readers of glTF
// understand.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// uv divided by the size of the image.
bake::Float2 in_image_units(const materials::TextureImage& image, const bake::Float2& uv_m);

/// The inverse of in_image_units(), to the bit, for uvs as Primitive::uvs has them: below 2^22 steps of
/// materials::uv_step_m() on an image, any on a material's texture, whose side is a power of two.
bake::Float2 in_metres(const materials::TextureImage& image, materials::ColourSource colour_source,
                       const bake::Float2& uv);

}  // namespace citykiln::exporters
