// Reads the meshes of a .glb.
#pragma once

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Reads the primitives of a mesh. Positions are in the tile's axes (x east, y north, z up), metres from its origin.
/// uvs keep the units of the file. Primitives that follow each other and have equal keys are joined. Checks that images
/// exist, but does not read them.
///
/// @param reader       A file without compression, as decompressed_glb() makes it.
/// @param mesh_number  Index in "meshes". An index of no mesh is an error.
/// @param features     The number of rows of the property table.
///
/// Throws FormatError for what citykiln does not write: missing attributes, indices without a vertex, an unknown layer.
std::vector<bake::Primitive> primitives_of(GltfReader& reader, int mesh_number, std::size_t features);

}  // namespace citykiln::exporters
