// Reads the property table of a .glb.
#pragma once

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/read/glb_reader.h"

namespace citykiln::exporters {

/// Reads the features and attributes that property_table() writes into the tile. Throws FormatError.
void read_property_table(GltfReader& reader, bake::BakedTile& tile);

}  // namespace citykiln::exporters
