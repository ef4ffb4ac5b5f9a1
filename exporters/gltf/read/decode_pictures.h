// Reads the images of a .glb: marking atlas, facade atlas, textures, cutouts.
#pragma once

#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Returns the index of the image that a mesh's primitives with ColourSource::kByCutout show, if there are any. Throws
/// FormatError.
std::optional<std::size_t> cutout_image_of(const tinygltf::Model& model, int mesh);

/// Reads all images into the tile, in the order in which add_pictures() writes them. Throws FormatError.
/// @param cutouts  The result of cutout_image_of() for each entry of tile.instanced.
void read_pictures(GltfReader& reader, std::span<const std::optional<std::size_t>> cutouts, bake::BakedTile& tile);

}  // namespace citykiln::exporters
