// Meshes out of a .glb.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb_reader.h"

namespace citykiln::exporters {

/// Of a mesh, by its number. Pictures are read after meshes: whether there is one is asked here. Throws FormatError.
/// @param features  How many rows the property table has.
std::vector<bake::Primitive> primitives_of(GltfReader& source, int mesh, std::size_t features);

}  // namespace citykiln::exporters
