// Reads the nodes of a .glb, and the meshes that they show.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Appends the primitives and instanced meshes of the nodes to a tile, in the order in which they were written. Layers
/// may be one node each, and buildings may be nodes of their own (NodeSplit in glb.h); their primitives are joined
/// again. Positions are in the plane's axes, texture coordinates in the units of the file.
///
/// Returns one value per entry of tile.instanced: the index of the cutout image that its material shows, or nothing.
///
/// Throws FormatError for anything that citykiln does not write, as all functions of glb_reader.h do: hundreds of
/// values are checked in nested calls. decode_glb() catches it and returns a Result. O(bytes of the meshes).
/// @param tile  Must have its features, which meshes refer to by index; without primitives and instanced meshes.
std::vector<std::optional<std::size_t>> read_nodes(GltfReader& reader, bake::BakedTile& tile);

}  // namespace citykiln::exporters
