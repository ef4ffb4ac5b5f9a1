// Texture coordinates on images lie on a grid, so that files may store them in other units and give them back exactly.
#pragma once

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"

namespace citykiln::bake {

/// The nearest place on an image's grid, a multiple of materials::uv_step_m() each way.
Vec2 snapped_uv(Vec2 uv, const materials::TextureImage& image);

/// Moves uvs on the marking atlas, the facade atlas and cutouts to multiples of materials::uv_step_m() of their image:
/// by at most a sixteenth of a texel. Twice changes nothing more. Up to 2^22 steps. O(vertices).
void snap_image_uvs(BakedTile& tile);
/// The same for a tile that shows a marking atlas which it does not hold.
void snap_image_uvs(BakedTile& tile, const materials::TextureImage& marking_atlas);
/// The same for the primitives of an instanced mesh that show a cutout alone.
void snap_image_uvs(std::vector<Primitive>& primitives, const impostor::Cutout& cutout);

}  // namespace citykiln::bake
