#include "exporters/gltf/compress_glb.h"

#include <cassert>
#include <cstring>
#include <set>
#include <stdexcept>
#include <string_view>

#include "compiler/contract/for_each_slot.h"
#include "exporters/gltf/draco_codec.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/glb_primitives.h"
#include "exporters/gltf/meshopt_codec.h"
#include "exporters/gltf/narrow_attributes.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

constexpr const char *kDraco = "KHR_draco_mesh_compression", *kMeshopt = "EXT_meshopt_compression",
                     *kQuantised = "KHR_mesh_quantization";

[[noreturn]] void refuse(const char* what) { throw std::runtime_error(what); }

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

void copy_view(const GlbParts& plain, Json& accessor, GlbParts& packed) {
  const Json& view = view_of(plain.gltf, accessor);
  accessor["bufferView"] = add_view(packed, bytes_of_view(plain, view));
  packed.gltf["bufferViews"].back()["target"] = view.at("target");
}

void copy_mesh(const GlbParts& plain, Json& primitive, GlbParts& packed) {
  for (Json* accessor : accessors_of(packed.gltf, primitive)) copy_view(plain, *accessor, packed);
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
    set_component(mesh.attributes[i].component, *accessors[i]);
  }
  add_meshopt_view(mesh.indices, *accessors.back(), packed, fallback_bytes);
}

// The number of each primitive's mesh, in the order of primitives_of.
std::vector<std::size_t> mesh_numbers(const Json& gltf) {
  std::vector<std::size_t> numbers;
  if (!gltf.contains("meshes")) return numbers;
  for (std::size_t m = 0; m < gltf["meshes"].size(); ++m)
    numbers.insert(numbers.end(), gltf["meshes"][m]["primitives"].size(), m);
  return numbers;
}

// Arrays of all primitives, narrowed and then encoded.
template <typename Encoded, typename Encode>
std::vector<Encoded> encoded_arrays(const GlbParts& plain, const NarrowPlan& plan, const std::vector<Json*>& primitives,
                                    int threads, Encode encode) {
  const std::vector<std::size_t> meshes = mesh_numbers(plain.gltf);
  return for_each_slot<Encoded>(primitives.size(), threads, [&](std::size_t i) {
    MeshArrays arrays = arrays_of(plain, *primitives[i]);
    narrow_steps(plan, meshes[i], primitives[i]->at("material").get<std::size_t>(), arrays);
    return encode(std::move(arrays), *primitives[i]);
  });
}

void compress_meshopt(const GlbParts& plain, GlbParts& packed, int threads) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const NarrowPlan plan = plan_narrowing(plain);
  const auto meshes =
      encoded_arrays<MeshoptMesh>(plain, plan, primitives, threads, [&](MeshArrays arrays, const Json& primitive) {
        const Json& indices = plain.gltf["accessors"].at(primitive.at("indices").get<std::size_t>());
        return encode_meshopt(std::move(arrays), bytes_of(component_of(indices)));
      });
  std::size_t fallback_bytes = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) add_meshopt(meshes[i], *primitives[i], packed, fallback_bytes);
  packed.gltf["buffers"].push_back(
      {{"byteLength", fallback_bytes}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}});
  scale_by_plan(plan, packed);
}

// ---- KHR_mesh_quantization -----------------------------------------------------------------------------------------

void add_narrow_attribute(const VertexAttribute& attribute, Json& accessor, GlbParts& packed) {
  accessor["bufferView"] = add_view(packed, attribute.bytes);
  Json& view = packed.gltf["bufferViews"].back();
  view["target"] = 34962;
  if (stride_of(attribute) != attribute.width * bytes_of(attribute.component))
    view["byteStride"] = stride_of(attribute);
  set_component(attribute.component, accessor);
}

void quantise_attributes(const GlbParts& plain, GlbParts& packed, int threads) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const NarrowPlan plan = plan_narrowing(plain);
  const auto meshes = encoded_arrays<MeshArrays>(plain, plan, primitives, threads, [&](MeshArrays arrays, const Json&) {
    narrow_directions(arrays);
    return arrays;
  });
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::vector<Json*> accessors = accessors_of(packed.gltf, *primitives[i]);
    for (std::size_t a = 0; a < meshes[i].attributes.size(); ++a)
      add_narrow_attribute(meshes[i].attributes[a], *accessors[a], packed);
    copy_view(plain, *accessors.back(), packed);
  }
  scale_by_plan(plan, packed);
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
  accessor["count"] = count;
  set_component(attribute.component, accessor);
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
    auto attribute = decode_meshopt({name, component_of(accessor), width_of(accessor), std::move(view)});
    if (!attribute) refuse("attributes that meshopt can decode");
    put_attribute(widened(std::move(*attribute), accessor), count, accessor, parts);
  }
  if (!is_meshopt(parts.gltf, *accessors.back())) return;
  const auto indices = decode_meshopt_indices(take_meshopt(unpacking, *accessors.back()));
  if (!indices) refuse("indices that meshopt can decode");
  put_indices(*indices, *accessors.back(), parts);
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
  } else if (compression == Compression::kMeshopt) {
    compress_meshopt(plain, packed, threads);
    demand(packed.gltf, kMeshopt), demand(packed.gltf, kQuantised);
  } else {
    quantise_attributes(plain, packed, threads);
    demand(packed.gltf, kQuantised);
  }
  return join_glb(std::move(packed));
}

std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes) {
  const std::string_view json = json_of_glb(bytes);
  if (json.find(kDraco) == json.npos && json.find(kQuantised) == json.npos) return std::nullopt;
  Unpacking unpacking{split_glb(bytes)};
  GlbParts& parts = unpacking.parts;
  unscale(parts);
  for (Json* primitive : primitives_of(parts.gltf)) {
    if (primitive->contains("extensions") && primitive->at("extensions").contains(kDraco)) {
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
