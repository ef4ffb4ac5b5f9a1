// Writes the meshes of a .glb: attributes, indices, materials.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// The mode of triangles in a glTF primitive.
inline constexpr int kTrianglesMode = 4;

/// Appends a mesh with one glTF primitive for each primitive, and returns its index. Its extras state the layer, or
/// those of the primitives if they differ.
///
/// @param primitives  Not empty.
/// @param cutout      The result of cutout_like() for an instanced mesh; else null.
std::size_t add_mesh(GlbBuilder& f, const std::string& name, std::span<const bake::Primitive> primitives,
                     const impostor::Cutout* cutout = nullptr);

/// Appends an accessor of positions, with the limits of their coordinates as POSITION requires, and returns its index.
std::size_t add_positions(GlbBuilder& f, const std::vector<bake::Float3>& positions);

/// Returns the value of a feature id extension: the attribute _FEATURE_ID_0 holds rows of property table 0.
nlohmann::json feature_ids(GlbBuilder& f, const char* extension);

}  // namespace citykiln::exporters
