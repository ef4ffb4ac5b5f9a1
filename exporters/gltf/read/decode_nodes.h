// Reads the nodes of a .glb, and the meshes they show.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Reads the primitives and instanced meshes of a tile from nodes of any split (encode_glb.cpp). Texture coordinates
/// keep the units of the file. Returns the index of the cutout image of each instanced mesh. Throws FormatError.
/// @param tile  Its features are read already.
std::vector<std::optional<std::size_t>> read_nodes(GltfReader& reader, bake::BakedTile& tile);

}  // namespace citykiln::exporters
