// Reads the meshes of a .glb.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Reads the primitives of a mesh. uvs keep the units of the file. Checks that images exist, but does not read them.
/// Throws FormatError.
/// @param features  The number of rows of the property table.
std::vector<bake::Primitive> primitives_of(GltfReader& reader, int mesh_number, std::size_t features);

}  // namespace citykiln::exporters
