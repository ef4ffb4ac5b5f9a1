#include "exporters/gltf/pack/glb_primitives.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "exporters/gltf/glb_names.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

constexpr const char* kOtherAccessors = "accessors as citykiln writes them";

std::vector<std::uint32_t> plain_indices(const GlbParts& plain, const Json& accessor) {
  const auto bytes = bytes_of_view(plain, view_of(plain.gltf, accessor));
  const std::size_t stride = bytes_of(component_of(accessor));
  std::vector<std::uint32_t> indices(bytes.size() / stride);
  // little-endian
  for (std::size_t i = 0; i < indices.size(); ++i) std::memcpy(&indices[i], bytes.data() + i * stride, stride);
  return indices;
}

bool carries_instances(const Json& node) {
  return (node.contains("extensions") && node["extensions"].contains(kInstancingExtension)) ||
         (node.contains("extras") && node["extras"].contains("feature"));
}

}  // namespace

std::vector<Json*> primitives_of(Json& gltf) {
  std::vector<Json*> primitives;
  if (!gltf.contains("meshes")) return primitives;
  for (Json& mesh : gltf.at("meshes"))
    for (Json& primitive : mesh.at("primitives")) primitives.push_back(&primitive);
  return primitives;
}

std::vector<std::size_t> instanced_meshes(const Json& gltf) {
  std::vector<std::size_t> meshes;
  for (const Json& node : gltf.at("nodes")) {
    if (!node.contains("mesh") || !carries_instances(node)) continue;
    const auto mesh = node["mesh"].get<std::size_t>();
    if (std::ranges::find(meshes, mesh) == meshes.end()) meshes.push_back(mesh);
  }
  return meshes;
}

std::vector<Json*> accessors_of(Json& gltf, const Json& primitive) {
  std::vector<Json*> accessors;
  for (const auto& [name, number] : primitive.at("attributes").items())
    accessors.push_back(&gltf.at("accessors").at(number.get<std::size_t>()));
  accessors.push_back(&gltf.at("accessors").at(primitive.at("indices").get<std::size_t>()));
  return accessors;
}

const Json& view_of(const Json& gltf, const Json& accessor) {
  return gltf.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
}

std::size_t width_of(const Json& accessor) {
  const auto& type = accessor.at("type").get_ref<const std::string&>();
  if (type == "SCALAR") return 1;
  if (type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4')
    return static_cast<std::size_t>(type[3] - '0');
  throw std::runtime_error(kOtherAccessors);
}

Component component_of(const Json& accessor) {
  const auto component = accessor.at("componentType").get<int>();
  for (const Component known : {Component::kByte, Component::kUnsignedByte, Component::kShort,
                                Component::kUnsignedShort, Component::kUnsignedInt, Component::kFloat})
    if (component == static_cast<int>(known)) return known;
  throw std::runtime_error(kOtherAccessors);
}

VertexAttribute attribute_of(const GlbParts& plain, const std::string& name, const Json& accessor) {
  const auto bytes = bytes_of_view(plain, view_of(plain.gltf, accessor));
  return {name, component_of(accessor), width_of(accessor), {bytes.begin(), bytes.end()}};
}

MeshArrays arrays_of(const GlbParts& plain, const Json& primitive) {
  const Json& accessors = plain.gltf.at("accessors");
  MeshArrays mesh;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    const Json& accessor = accessors.at(number.get<std::size_t>());
    mesh.count = accessor.at("count").get<std::size_t>();
    mesh.attributes.push_back(attribute_of(plain, name, accessor));
  }
  mesh.indices = plain_indices(plain, accessors.at(primitive.at("indices").get<std::size_t>()));
  return mesh;
}

}  // namespace citykiln::exporters
