#include "exporters/gltf/compress_glb.h"

#include <cassert>
#include <cstring>
#include <set>
#include <stdexcept>
#include <string_view>

#include "compiler/contract/for_each_slot.h"
#include "exporters/gltf/draco_codec.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/meshopt_codec.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

constexpr const char *kDraco = "KHR_draco_mesh_compression", *kMeshopt = "EXT_meshopt_compression",
                     *kQuantised = "KHR_mesh_quantization";

[[noreturn]] void refuse(const char* what) { throw std::runtime_error(what); }

std::size_t width_of(const Json& accessor) {
  const auto& type = accessor.at("type").get_ref<const std::string&>();
  if (type == "SCALAR") return 1;
  if (type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4')
    return static_cast<std::size_t>(type[3] - '0');
  refuse("accessors as citykiln writes them");
}

Component component_of(const Json& accessor) {
  const auto component = accessor.at("componentType").get<int>();
  for (const Component known : {Component::kUnsignedByte, Component::kShort, Component::kUnsignedShort,
                                Component::kUnsignedInt, Component::kFloat})
    if (component == static_cast<int>(known)) return known;
  refuse("accessors as citykiln writes them");
}

// ---- primitives of a plain file ------------------------------------------------------------------------------------

const Json& view_of(const Json& gltf, const Json& accessor) {
  return gltf.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
}

VertexAttribute attribute_of(const GlbParts& plain, const std::string& name, const Json& accessor) {
  const auto bytes = bytes_of_view(plain, view_of(plain.gltf, accessor));
  return {name, component_of(accessor), width_of(accessor), {bytes.begin(), bytes.end()}};
}

std::vector<std::uint32_t> indices_of(const GlbParts& plain, const Json& accessor) {
  const auto bytes = bytes_of_view(plain, view_of(plain.gltf, accessor));
  const std::size_t stride = bytes_of(component_of(accessor));
  std::vector<std::uint32_t> indices(bytes.size() / stride);
  // little-endian
  for (std::size_t i = 0; i < indices.size(); ++i) std::memcpy(&indices[i], bytes.data() + i * stride, stride);
  return indices;
}

MeshArrays arrays_of(const GlbParts& plain, const Json& primitive) {
  const Json& accessors = plain.gltf.at("accessors");
  MeshArrays mesh;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    const Json& accessor = accessors.at(number.get<std::size_t>());
    mesh.count = accessor.at("count").get<std::size_t>();
    mesh.attributes.push_back(attribute_of(plain, name, accessor));
  }
  mesh.indices = indices_of(plain, accessors.at(primitive.at("indices").get<std::size_t>()));
  return mesh;
}

// All primitives, mesh by mesh.
std::vector<Json*> primitives_of(Json& gltf) {
  std::vector<Json*> primitives;
  if (!gltf.contains("meshes")) return primitives;
  for (Json& mesh : gltf.at("meshes"))
    for (Json& primitive : mesh.at("primitives")) primitives.push_back(&primitive);
  return primitives;
}

// The accessors of a primitive, its attributes' in their order, then its indices'.
std::vector<Json*> accessors_of(Json& gltf, const Json& primitive) {
  std::vector<Json*> accessors;
  for (const auto& [name, number] : primitive.at("attributes").items())
    accessors.push_back(&gltf.at("accessors").at(number.get<std::size_t>()));
  accessors.push_back(&gltf.at("accessors").at(primitive.at("indices").get<std::size_t>()));
  return accessors;
}

// ---- views that are not packed -------------------------------------------------------------------------------------

// All references to buffer views, but for those of primitives' accessors.
std::vector<Json*> other_views(Json& gltf) {
  std::vector<Json*> numbers;
  std::set<Json*> of_primitives;
  for (Json* primitive : primitives_of(gltf))
    for (Json* accessor : accessors_of(gltf, *primitive)) of_primitives.insert(accessor);
  if (gltf.contains("accessors"))
    for (Json& accessor : gltf["accessors"])
      if (!of_primitives.contains(&accessor)) numbers.push_back(&accessor["bufferView"]);
  if (gltf.contains("images"))
    for (Json& image : gltf["images"]) numbers.push_back(&image["bufferView"]);
  for (Json& table : gltf["extensions"]["EXT_structural_metadata"]["propertyTables"])
    for (Json& property : table["properties"])
      for (const char* view : {"values", "stringOffsets"})
        if (property.contains(view)) numbers.push_back(&property[view]);
  return numbers;
}

void copy_other_views(const GlbParts& plain, GlbParts& packed) {
  packed.gltf["bufferViews"] = Json::array();
  for (Json* number : other_views(packed.gltf))
    *number = add_view(packed, bytes_of_view(plain, plain.gltf["bufferViews"][number->get<std::size_t>()]));
}

void copy_mesh(const GlbParts& plain, Json& primitive, GlbParts& packed) {
  for (Json* accessor : accessors_of(packed.gltf, primitive)) {
    const Json& view = view_of(plain.gltf, *accessor);
    (*accessor)["bufferView"] = add_view(packed, bytes_of_view(plain, view));
    packed.gltf["bufferViews"].back()["target"] = view.at("target");
  }
}

// ---- meshopt -------------------------------------------------------------------------------------------------------

// Adds a view. The extension requires a second buffer, which does not exist, and offsets in it.
void add_meshopt_view(const MeshoptView& view, Json& accessor, GlbParts& packed, std::size_t& fallback_bytes) {
  const bool is_attribute = view.mode == "ATTRIBUTES";
  const Json extension = {{"buffer", 0},
                          {"byteOffset", append(packed, view.bytes)},
                          {"byteLength", view.bytes.size()},
                          {"byteStride", view.stride},
                          {"count", view.count},
                          {"mode", view.mode},
                          {"filter", view.filter}};
  Json whole = {{"buffer", 1},
                {"byteOffset", fallback_bytes},
                {"byteLength", view.count * view.stride},
                {"target", is_attribute ? 34962 : 34963},
                {"extensions", {{kMeshopt, extension}}}};
  if (is_attribute) whole["byteStride"] = view.stride;
  fallback_bytes += (view.count * view.stride + 3) / 4 * 4;
  Json& views = packed.gltf["bufferViews"];
  accessor["bufferView"] = views.size(), accessor["count"] = view.count;
  views.push_back(std::move(whole));
}

void add_meshopt(const MeshoptMesh& mesh, const Json& primitive, GlbParts& packed, std::size_t& fallback_bytes) {
  const std::vector<Json*> accessors = accessors_of(packed.gltf, primitive);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    add_meshopt_view(mesh.attributes[i].view, *accessors[i], packed, fallback_bytes);
    (*accessors[i])["componentType"] = static_cast<int>(mesh.attributes[i].component);
    if (mesh.attributes[i].component == Component::kShort) (*accessors[i])["normalized"] = true;
  }
  add_meshopt_view(mesh.indices, *accessors.back(), packed, fallback_bytes);
}

void compress_meshopt(const GlbParts& plain, GlbParts& packed, int threads) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const auto meshes = for_each_slot<MeshoptMesh>(primitives.size(), threads, [&](std::size_t i) {
    const Json& indices = plain.gltf["accessors"].at(primitives[i]->at("indices").get<std::size_t>());
    return encode_meshopt(arrays_of(plain, *primitives[i]), bytes_of(component_of(indices)));
  });
  std::size_t fallback_bytes = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) add_meshopt(meshes[i], *primitives[i], packed, fallback_bytes);
  packed.gltf["buffers"].push_back(
      {{"byteLength", fallback_bytes}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}});
}

// ---- Draco ---------------------------------------------------------------------------------------------------------

void add_draco(const DracoMesh& mesh, Json& primitive, GlbParts& packed) {
  Json ids = Json::object();
  std::size_t i = 0;
  for (const auto& [name, number] : primitive.at("attributes").items()) ids[name] = mesh.ids[i++];
  primitive["extensions"][kDraco] = {{"bufferView", add_view(packed, mesh.bytes)}, {"attributes", ids}};
  const std::vector<Json*> accessors = accessors_of(packed.gltf, primitive);
  for (Json* accessor : accessors) accessor->erase("bufferView"), (*accessor)["count"] = mesh.count;
  (*accessors.back())["count"] = 3 * mesh.triangles;
  (*accessors.back())["componentType"] =
      static_cast<int>(mesh.count < 65535 ? Component::kUnsignedShort : Component::kUnsignedInt);
}

void compress_draco(const GlbParts& plain, GlbParts& packed, int threads) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const auto meshes = for_each_slot<std::optional<DracoMesh>>(
      primitives.size(), threads, [&](std::size_t i) { return encode_draco(arrays_of(plain, *primitives[i])); });
  for (std::size_t i = 0; i < meshes.size(); ++i)
    meshes[i] ? add_draco(*meshes[i], *primitives[i], packed) : copy_mesh(plain, *primitives[i], packed);
}

void demand(Json& gltf, const char* extension) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) gltf[list].push_back(extension);
}

// ---- unpacking -----------------------------------------------------------------------------------------------------

void put_attribute(const VertexAttribute& attribute, std::size_t count, Json& accessor, GlbParts& parts) {
  accessor["bufferView"] = add_view(parts, attribute.bytes);
  accessor["count"] = count, accessor["componentType"] = static_cast<int>(attribute.component);
  accessor.erase("byteOffset");
  if (attribute.component == Component::kFloat) accessor.erase("normalized");
}

void put_indices(const std::vector<std::uint32_t>& indices, Json& accessor, GlbParts& parts) {
  std::vector<unsigned char> bytes(indices.size() * 4);
  if (!indices.empty()) std::memcpy(bytes.data(), indices.data(), bytes.size());
  put_attribute({"", Component::kUnsignedInt, 1, std::move(bytes)}, indices.size(), accessor, parts);
}

// A file while its meshes are unpacked. Each byte is used once, so that no small file makes a large tile.
struct Unpacking {
  GlbParts parts;
  std::size_t unread_bytes = parts.buffer.size();

  std::vector<unsigned char> take(const Json& view) {
    const auto bytes = bytes_of_view(parts, view);
    if (bytes.size() > unread_bytes) refuse("each byte of the buffer to be used once");
    unread_bytes -= bytes.size();
    return {bytes.begin(), bytes.end()};
  }
};

void unpack_draco(Json& primitive, Unpacking& unpacking) {
  GlbParts& parts = unpacking.parts;
  const Json extension = primitive.at("extensions").at(kDraco);
  std::vector<VertexAttribute> wanted;
  std::vector<int> ids;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    const Json& accessor = parts.gltf.at("accessors").at(number.get<std::size_t>());
    wanted.push_back({name, component_of(accessor), width_of(accessor), {}});
    ids.push_back(extension.at("attributes").at(name).get<int>());
  }
  const Json& view = parts.gltf.at("bufferViews").at(extension.at("bufferView").get<std::size_t>());
  const auto mesh = decode_draco(unpacking.take(view), std::move(wanted), ids);
  if (!mesh) refuse("meshes that Draco can decode");
  const std::vector<Json*> accessors = accessors_of(parts.gltf, primitive);
  for (std::size_t i = 0; i < mesh->attributes.size(); ++i)
    put_attribute(mesh->attributes[i], mesh->count, *accessors[i], parts);
  put_indices(mesh->indices, *accessors.back(), parts);
  primitive.at("extensions").erase(kDraco);
}

bool is_meshopt(const Json& gltf, const Json& accessor) {
  if (!accessor.contains("bufferView")) return false;
  const Json& view = view_of(gltf, accessor);
  return view.contains("extensions") && view.at("extensions").contains(kMeshopt);
}

MeshoptView take_meshopt(Unpacking& unpacking, const Json& accessor) {
  const Json& extension = view_of(unpacking.parts.gltf, accessor).at("extensions").at(kMeshopt);
  return {unpacking.take(extension), extension.at("count").get<std::size_t>(),
          extension.at("byteStride").get<std::size_t>(), extension.at("mode").get<std::string>(),
          extension.value("filter", std::string("NONE"))};
}

void unpack_meshopt(const Json& primitive, Unpacking& unpacking) {
  GlbParts& parts = unpacking.parts;
  const std::vector<Json*> accessors = accessors_of(parts.gltf, primitive);
  std::size_t i = 0;
  for (const auto& [name, number] : primitive.at("attributes").items()) {
    Json& accessor = *accessors[i++];
    if (!is_meshopt(parts.gltf, accessor)) continue;
    MeshoptView view = take_meshopt(unpacking, accessor);
    const std::size_t count = view.count;
    const auto attribute = decode_meshopt({name, component_of(accessor), width_of(accessor), std::move(view)});
    if (!attribute) refuse("attributes that meshopt can decode");
    put_attribute(*attribute, count, accessor, parts);
  }
  if (!is_meshopt(parts.gltf, *accessors.back())) return;
  const auto indices = decode_meshopt_indices(take_meshopt(unpacking, *accessors.back()));
  if (!indices) refuse("indices that meshopt can decode");
  put_indices(*indices, *accessors.back(), parts);
}

// Removes the second buffer, and the references to it of views that are unpacked.
void forget_fallback(Json& gltf) {
  for (Json& view : gltf.at("bufferViews"))
    if (view.contains("extensions") && view.at("extensions").contains(kMeshopt))
      view = {{"buffer", 0}, {"byteLength", 1}};
  gltf["buffers"] = Json::array({Json::object()});
}

}  // namespace

std::vector<std::byte> compressed_glb(GlbParts plain, Compression compression, int threads) {
  assert(compression != Compression::kNone);
  GlbParts packed{plain.gltf, {}};
  if (primitives_of(packed.gltf).empty()) return join_glb(std::move(plain));
  copy_other_views(plain, packed);
  if (compression == Compression::kDraco) {
    compress_draco(plain, packed, threads);
    demand(packed.gltf, kDraco);
  } else {
    compress_meshopt(plain, packed, threads);
    demand(packed.gltf, kMeshopt), demand(packed.gltf, kQuantised);
  }
  return join_glb(std::move(packed));
}

std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  if (json.find(kDraco) == json.npos && json.find(kMeshopt) == json.npos) return std::nullopt;
  Unpacking unpacking{split_glb(bytes)};
  GlbParts& parts = unpacking.parts;
  for (Json* primitive : primitives_of(parts.gltf)) {
    if (primitive->contains("extensions") && primitive->at("extensions").contains(kDraco))
      unpack_draco(*primitive, unpacking);
    else
      unpack_meshopt(*primitive, unpacking);
  }
  forget_fallback(parts.gltf);
  return join_glb(std::move(parts));
}

}  // namespace citykiln::exporters
