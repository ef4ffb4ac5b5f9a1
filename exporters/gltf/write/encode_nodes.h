// Writes the nodes of a .glb: the tile, its layers, buildings and instances, each with its mesh.
#pragma once

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// Adds the root and all nodes below it, by the options' split and target:
///
///     tile_3_-2                        NodeSplit::kLayer
///     ├── ground, roads, water         a mesh each
///     ├── buildings                    a mesh, or with NodeSplit::kBuilding a node per building: way_1234
///     ├── structures                   a mesh
///     ├── props                        a mesh, and a node per lamp
///     └── plants                       a mesh, and a node per plant: oak_3
///
/// With NodeSplit::kTile the root has the only mesh that is not instanced. Empty layers are left out. Meshes are
/// numbered in the order of nodes; the instances of a mesh follow each other.
void add_nodes(GlbBuilder& f, nlohmann::json root);

}  // namespace citykiln::exporters
