// Pictures out of a .glb: the sheet, the atlas, textures, cutouts.
#pragma once

#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb_reader.h"

namespace citykiln::exporters {

/// Which picture colours a mesh's primitives on cutouts, if any. Throws FormatError, here and below.
std::optional<std::size_t> cutout_image_of(const tinygltf::Model& model, int mesh);

/// The sheet, if any, the atlas's two to four, if any, then colours and normals of materials, then cutouts.
/// @param cutouts  One an entry of tile.instanced, as cutout_image_of() says.
void read_pictures(GltfReader& source, std::span<const std::optional<std::size_t>> cutouts, bake::BakedTile& tile);

}  // namespace citykiln::exporters
