// decompressed_glb() of compress_glb.h.
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pack/compress_glb.h"
#include "exporters/gltf/pack/draco_codec.h"
#include "exporters/gltf/pack/glb_primitives.h"
#include "exporters/gltf/pack/meshopt_codec.h"
#include "exporters/gltf/pack/narrow_attributes.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse_file(const char* what) { throw std::runtime_error(what); }

void put_attribute(const VertexAttribute& attribute, std::size_t count, Json& accessor, GlbParts& parts) {
  accessor["bufferView"] = add_view(parts, attribute.bytes);
  accessor["count"] = count, accessor.erase("byteOffset");
  set_component(attribute.component, accessor);
}

void put_indices(const std::vector<std::uint32_t>& indices, Json& accessor, GlbParts& parts) {
  std::vector<unsigned char> bytes(indices.size() * 4);
  if (!indices.empty()) std::memcpy(bytes.data(), indices.data(), bytes.size());
  put_attribute({"", Component::kUnsignedInt, 1, std::move(bytes)}, indices.size(), accessor, parts);
}

// A view of meshopt, unpacked.
struct UnpackedView {
  MeshoptKind kind;
  std::vector<unsigned char> bytes;
  std::size_t unread_bytes = bytes.size();
};

// A file while its meshes are unpacked. Each byte is used once, packed and unpacked, so that no small file makes a
// large tile.
struct Unpacking {
  GlbParts parts;
  std::size_t unread_bytes = parts.buffer.size();
  std::map<std::size_t, UnpackedView> views{};  // by number

  std::vector<unsigned char> take(const Json& view) {
    const auto bytes = bytes_of_view(parts, view);
    if (bytes.size() > unread_bytes) refuse_file("each byte of the buffer to be used once");
    unread_bytes -= bytes.size();
    return {bytes.begin(), bytes.end()};
  }
};

void unpack_draco(Json& primitive, Unpacking& unpacking) {
  GlbParts& parts = unpacking.parts;
  const Json extension = primitive.at("extensions").at(kDracoExtension);
  std::vector<VertexAttribute> wanted;
  std::vector<int> ids;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    const Json& accessor = parts.gltf.at("accessors").at(number.get<std::size_t>());
    wanted.push_back({name, component_of(accessor), width_of(accessor), {}});
    ids.push_back(extension.at("attributes").at(name).get<int>());
  }
  const Json& view = parts.gltf.at("bufferViews").at(extension.at("bufferView").get<std::size_t>());
  const auto mesh = decode_draco(unpacking.take(view), std::move(wanted), ids);
  if (!mesh) refuse_file("meshes that Draco can decode");
  const std::vector<Json*> accessors = accessors_of(parts.gltf, primitive);
  for (std::size_t i = 0; i < mesh->attributes.size(); ++i)
    put_attribute(mesh->attributes[i], mesh->count, *accessors[i], parts);
  put_indices(mesh->indices, *accessors.back(), parts);
  primitive.at("extensions").erase(kDracoExtension);
}

bool is_meshopt(const Json& gltf, const Json& accessor) {
  if (!accessor.contains("bufferView")) return false;
  const Json& view = view_of(gltf, accessor);
  return view.contains("extensions") && view.at("extensions").contains(kMeshoptExtension);
}

UnpackedView unpacked_view(Unpacking& unpacking, const Json& extension) {
  const MeshoptKind kind{extension.at("byteStride").get<std::size_t>(), extension.at("mode").get<std::string>(),
                         extension.value("filter", std::string("NONE"))};
  auto bytes = decode_meshopt({kind, extension.at("count").get<std::size_t>(), unpacking.take(extension)});
  if (!bytes) refuse_file("views that meshopt can decode");
  return {kind, std::move(*bytes)};
}

// The elements of an accessor.
MeshoptArray take_meshopt(Unpacking& unpacking, const Json& accessor) {
  const auto number = accessor.at("bufferView").get<std::size_t>();
  auto found = unpacking.views.find(number);
  if (found == unpacking.views.end()) {
    const Json& extension = view_of(unpacking.parts.gltf, accessor).at("extensions").at(kMeshoptExtension);
    found = unpacking.views.emplace(number, unpacked_view(unpacking, extension)).first;
  }
  UnpackedView& view = found->second;
  const auto offset = accessor.value("byteOffset", std::size_t{0}), count = accessor.at("count").get<std::size_t>();
  if (count > view.unread_bytes / view.kind.stride || offset > view.bytes.size() ||
      count * view.kind.stride > view.bytes.size() - offset)
    refuse_file("accessors within their views");
  view.unread_bytes -= count * view.kind.stride;
  const auto first = view.bytes.begin() + static_cast<std::ptrdiff_t>(offset);
  return {view.kind, {first, first + static_cast<std::ptrdiff_t>(count * view.kind.stride)}};
}

std::vector<std::uint32_t> unpacked_indices(const MeshoptArray& array) {
  if (array.kind.mode != "TRIANGLES") refuse_file("indices that are packed as triangles");
  std::vector<std::uint32_t> indices(array.bytes.size() / array.kind.stride);
  for (std::size_t i = 0; i < indices.size(); ++i)
    std::memcpy(&indices[i], &array.bytes[i * array.kind.stride], array.kind.stride);
  return indices;
}

void unpack_meshopt(const Json& primitive, Unpacking& unpacking) {
  GlbParts& parts = unpacking.parts;
  const std::vector<Json*> accessors = accessors_of(parts.gltf, primitive);
  std::size_t i = 0;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    Json& accessor = *accessors[i++];
    if (!is_meshopt(parts.gltf, accessor)) continue;
    MeshoptArray array = take_meshopt(unpacking, accessor);
    VertexAttribute attribute{name, component_of(accessor), width_of(accessor), std::move(array.bytes)};
    if (!can_hold(array.kind, attribute)) refuse_file("attributes that meshopt can decode");
    put_attribute(widened(std::move(attribute), accessor), accessor.at("count").get<std::size_t>(), accessor, parts);
  }
  if (is_meshopt(parts.gltf, *accessors.back()))
    put_indices(unpacked_indices(take_meshopt(unpacking, *accessors.back())), *accessors.back(), parts);
}

bool is_narrow(const Json& accessor) {
  const Component component = component_of(accessor);
  return component == Component::kByte || component == Component::kShort || component == Component::kUnsignedShort;
}

// Reads attributes of 8 and 16 bits; others stay where they are.
void unpack_narrow(const Json& primitive, Unpacking& unpacking) {
  GlbParts& parts = unpacking.parts;
  const std::vector<Json*> accessors = accessors_of(parts.gltf, primitive);
  std::size_t i = 0;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    Json& accessor = *accessors[i++];
    if (!is_narrow(accessor)) continue;
    VertexAttribute attribute{name, component_of(accessor), width_of(accessor),
                              unpacking.take(view_of(parts.gltf, accessor))};
    const std::size_t count = attribute.bytes.size() / stride_of(attribute);
    put_attribute(widened(std::move(attribute), accessor), count, accessor, parts);
  }
}

// Removes the second buffer, and the references to it of views that are unpacked.
void forget_fallback(Json& gltf) {
  for (Json& view : gltf.at("bufferViews"))
    if (view.contains("extensions") && view.at("extensions").contains(kMeshoptExtension))
      view = {{"buffer", 0}, {"byteLength", 1}};
  gltf["buffers"] = Json::array({Json::object()});
}

}  // namespace

std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  if (json.find(kDracoExtension) == json.npos && json.find(kQuantizationExtension) == json.npos) return std::nullopt;
  Unpacking unpacking{split_glb(bytes)};
  GlbParts& parts = unpacking.parts;
  unscale(parts);
  for (Json* primitive : primitives_of(parts.gltf)) {
    if (primitive->contains("extensions") && primitive->at("extensions").contains(kDracoExtension)) {
      unpack_draco(*primitive, unpacking);
      continue;
    }
    unpack_meshopt(*primitive, unpacking);
    unpack_narrow(*primitive, unpacking);
  }
  forget_fallback(parts.gltf);
  return join_glb(std::move(parts));
}

}  // namespace citykiln::exporters
