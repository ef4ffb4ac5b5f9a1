// Reads the images of a .glb: marking atlas, facade atlas, textures, cutouts.
#pragma once

#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb_reader.h"

namespace citykiln::exporters {

/// The index of the image of a mesh's primitives with ColourSource::kByCutout, if it has any. Throws FormatError, here
/// and below.
std::optional<std::size_t> cutout_image_of(const tinygltf::Model& model, int mesh);

/// Reads all images into the tile, in the order in which add_pictures() writes them.
/// @param cutouts  One per entry of tile.instanced, as cutout_image_of() returns them.
void read_pictures(GltfReader& reader, std::span<const std::optional<std::size_t>> cutouts, bake::BakedTile& tile);

}  // namespace citykiln::exporters
