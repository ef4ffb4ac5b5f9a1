// Finds the primitives of an unpacked .glb and returns them as arrays, for the passes that pack them.
#pragma once

#include <string>
#include <vector>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// Returns all primitives, mesh by mesh.
std::vector<nlohmann::json*> primitives_of(nlohmann::json& gltf);

/// Returns the distinct meshes of instances (plants, lamps), in the order of nodes.
std::vector<std::size_t> instanced_meshes(const nlohmann::json& gltf);

/// Returns the accessors of a primitive: one for each attribute, in their order, then the accessor of its indices.
std::vector<nlohmann::json*> accessors_of(nlohmann::json& gltf, const nlohmann::json& primitive);

/// Returns the buffer view of an accessor.
const nlohmann::json& view_of(const nlohmann::json& gltf, const nlohmann::json& accessor);

/// Returns the number of components per element, or the component type, of an accessor. Throws std::runtime_error for
/// types that citykiln does not write.
std::size_t width_of(const nlohmann::json& accessor);
Component component_of(const nlohmann::json& accessor);

/// Returns one attribute, or all attributes and the indices of a primitive.
VertexAttribute attribute_of(const GlbParts& plain, const std::string& name, const nlohmann::json& accessor);
MeshArrays arrays_of(const GlbParts& plain, const nlohmann::json& primitive);

}  // namespace citykiln::exporters
