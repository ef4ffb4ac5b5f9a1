// Writes the meshes of a .glb: attributes, indices, materials.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// The mode of triangles in a glTF primitive.
inline constexpr int kTrianglesMode = 4;

/// Appends a mesh and returns its index in the array "meshes". Each primitive of the tile becomes one glTF primitive,
/// or several if it has more than 65535 vertices and can be divided between objects. Materials and images that it needs
/// are added. The mesh's extras name the layer; if the layers differ, each glTF primitive has extras with its own.
///
/// @param primitives  Not empty. Positions from the tile's origin, x east, y north, z up (bake/baked_tile.h).
/// @param cutout      The result of cutout_like() for an instanced mesh; else null.
std::size_t add_mesh(GlbBuilder& f, const std::string& name, std::span<const bake::Primitive> primitives,
                     const impostor::Cutout* cutout = nullptr);

/// Appends an accessor of positions for the attribute POSITION, with "min" and "max" as glTF requires, and returns its
/// index.
///
/// @param positions  In the tile's axes, x east, y north, z up. The accessor holds them in glTF's axes, y up
///                   (to_gltf()).
std::size_t add_positions(GlbBuilder& f, const std::vector<bake::Float3>& positions);

/// Returns the JSON value of a feature id extension, for the object "extensions" of a glTF primitive
/// (EXT_mesh_features) or of a node with instances (EXT_instance_features). It says that the attribute _FEATURE_ID_0
/// holds rows of property table 0. Adds the extension to those that the file uses.
nlohmann::json feature_ids(GlbBuilder& f, const char* extension);

}  // namespace citykiln::exporters
