// Writes the meshes of a .glb: attributes, indices, materials.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// The mode of primitives, by glTF's number.
inline constexpr int kTrianglesMode = 4;

/// Appends a mesh with a glTF primitive per primitive, and returns its index.
///
/// Extras say the layer of the mesh, or of each primitive where layers differ.
/// @param primitives  Not empty.
/// @param cutout      As cutout_like() returns it for an instanced mesh; else null.
std::size_t add_mesh(GlbBuilder& f, const std::string& name, std::span<const bake::Primitive> primitives,
                     const impostor::Cutout* cutout = nullptr);

/// Adds positions with the limits of their coordinates, which POSITION must have.
std::size_t add_positions(GlbBuilder& f, const std::vector<bake::Float3>& positions);

/// A feature id extension: the attribute _FEATURE_ID_0 indexes rows of property table 0.
nlohmann::json feature_ids(GlbBuilder& f, const char* extension);

}  // namespace citykiln::exporters
