// The primitives of a plain .glb as arrays, for the passes that pack them.
#pragma once

#include <string>
#include <vector>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// All primitives, mesh by mesh.
std::vector<nlohmann::json*> primitives_of(nlohmann::json& gltf);

/// The meshes of instances (plants, lamps), each once, in the order of nodes.
std::vector<std::size_t> instanced_meshes(const nlohmann::json& gltf);

/// The accessors of a primitive: its attributes' in their order, then its indices'.
std::vector<nlohmann::json*> accessors_of(nlohmann::json& gltf, const nlohmann::json& primitive);

/// The buffer view of an accessor.
const nlohmann::json& view_of(const nlohmann::json& gltf, const nlohmann::json& accessor);

/// The type of an accessor. Throw std::runtime_error for those that citykiln does not write.
std::size_t width_of(const nlohmann::json& accessor);
Component component_of(const nlohmann::json& accessor);

/// An attribute, and all of a primitive with its indices.
VertexAttribute attribute_of(const GlbParts& plain, const std::string& name, const nlohmann::json& accessor);
MeshArrays arrays_of(const GlbParts& plain, const nlohmann::json& primitive);

}  // namespace citykiln::exporters
