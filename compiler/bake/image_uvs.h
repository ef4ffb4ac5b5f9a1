// Snaps texture coordinates on images to a grid, so that files can store them in other units without loss.
#pragma once

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"

namespace citykiln::bake {

/// The nearest point on an image's grid, a multiple of materials::uv_step_m() each way.
Vec2 snapped_uv(Vec2 uv, const materials::TextureImage& image);

/// Moves the uvs of primitives that show the marking atlas, the facade atlas or a cutout (an image with transparency)
/// to multiples of materials::uv_step_m() of that image. No uv moves by more than a sixteenth of a texel. A second call
/// changes nothing. Exact up to 2^22 steps. O(vertices).
void snap_image_uvs(BakedTile& tile);
/// Snaps uvs of a tile whose marking atlas is kept outside the tile.
void snap_image_uvs(BakedTile& tile, const materials::TextureImage& marking_atlas);
/// Snaps uvs of an instanced mesh whose only image is a cutout.
void snap_image_uvs(std::vector<Primitive>& primitives, const impostor::Cutout& cutout);

}  // namespace citykiln::bake
