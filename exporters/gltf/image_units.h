// Converts texture coordinates between metres, as in a tile, and units of an image's size, as all glTF readers
// understand.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns uv divided by the size of the image.
bake::Float2 in_image_units(const materials::TextureImage& image, const bake::Float2& uv_m);

/// The bit-exact inverse of in_image_units() for uvs as in Primitive::uvs: on an image below 2^22 steps of
/// materials::uv_step_m(), on a material's texture any, since its side is a power of two.
bake::Float2 in_metres(const materials::TextureImage& image, materials::ColourSource colour_source,
                       const bake::Float2& uv);

}  // namespace citykiln::exporters
