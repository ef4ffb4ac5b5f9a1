// The part of an atlas that each face of a primitive shows.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// Returns for each triangle the texels that the bounds of its face's uvs touch. Triangles that share vertices,
/// directly or through others, are one face; faces on an atlas share none. Uvs may be a sixteenth of a texel off.
///
/// @param primitive  With uvs: metres on the image.
///
/// Guarantees: the rectangles depend on the size of texels and on uvs relative to whole texels, so that a face has the
/// same one wherever its picture lies on an atlas. Total. O(vertices + triangles).
std::vector<TexelRectangle> face_rectangles(const bake::Primitive& primitive, const materials::TextureImage& image);

}  // namespace citykiln::preview
