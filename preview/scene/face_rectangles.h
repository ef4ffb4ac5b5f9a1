// The part of an atlas that each face of a primitive shows.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// Returns for each triangle the texels that the bounds of its face's uvs touch. A face is all triangles that are
/// connected by shared vertices; faces on an atlas share none. Uvs may be a sixteenth of a texel off.
///
/// @param primitive  Has uvs: metres on the image.
///
/// Guarantees: the rectangles depend only on the size of texels and on uvs relative to whole texels, so a face has an
/// equal rectangle wherever its picture lies on an atlas. Accepts any uvs. O(vertices + triangles).
std::vector<TexelRectangle> face_rectangles(const bake::Primitive& primitive, const materials::TextureImage& image);

}  // namespace citykiln::preview
