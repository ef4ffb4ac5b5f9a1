#include "exporters/gltf/pack/compress_glb.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

#include "compiler/contract/system/for_each_slot.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pack/draco_codec.h"
#include "exporters/gltf/pack/glb_primitives.h"
#include "exporters/gltf/pack/meshopt_codec.h"
#include "exporters/gltf/pack/narrow_attributes.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

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
  for (Json& table : gltf["extensions"][kMetadataExtension]["propertyTables"])
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

// Adds a view and returns its number. The extension requires a second buffer, which does not exist, and offsets in it.
std::size_t add_meshopt_view(const MeshoptView& view, GlbParts& packed, std::size_t& fallback_bytes) {
  const auto& [stride, mode, filter] = view.kind;
  const bool is_attribute = mode == "ATTRIBUTES";
  const Json extension = {{"buffer", 0},
                          {"byteOffset", append(packed, view.bytes)},
                          {"byteLength", view.bytes.size()},
                          {"byteStride", stride},
                          {"count", view.count},
                          {"mode", mode},
                          {"filter", filter}};
  Json whole = {{"buffer", 1},
                {"byteOffset", fallback_bytes},
                {"byteLength", view.count * stride},
                {"target", is_attribute ? 34962 : 34963},
                {"extensions", {{kMeshoptExtension, extension}}}};
  if (is_attribute) whole["byteStride"] = stride;
  fallback_bytes += (view.count * stride + 3) / 4 * 4;
  packed.gltf["bufferViews"].push_back(std::move(whole));
  return packed.gltf["bufferViews"].size() - 1;
}

// Arrays that follow each other in one view, and the accessors of each.
struct SharedView {
  MeshoptArray array;
  std::vector<Json*> accessors;
  std::size_t vertices = 0;  // the most of a mesh

  void add(MeshoptArray&& part, std::size_t of_vertices, Json& accessor) {
    if (!array.bytes.empty()) accessor["byteOffset"] = array.bytes.size();
    accessor["count"] = part.bytes.size() / part.kind.stride;
    array.kind = part.kind, vertices = std::max(vertices, of_vertices);
    array.bytes.insert(array.bytes.end(), part.bytes.begin(), part.bytes.end());
    accessors.push_back(&accessor);
  }
};

// Attributes of the tile's own meshes share views; each prototype has its own, which can go into a file
// (shared_layout.h). Indices share none: the codec counts vertices that have not been used yet from the view's begin.
struct SharedViews {
  std::map<std::pair<std::size_t, MeshoptKind>, SharedView> attributes{};  // by group and kind
  std::vector<SharedView> indices{};
};

void add_meshopt(MeshoptMesh&& mesh, std::size_t group, const Json& primitive, GlbParts& packed, SharedViews& views) {
  const std::vector<Json*> accessors = accessors_of(packed.gltf, primitive);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    set_component(mesh.components[i], *accessors[i]);
    views.attributes[{group, mesh.attributes[i].kind}].add(std::move(mesh.attributes[i]), mesh.count, *accessors[i]);
  }
  views.indices.emplace_back().add(std::move(mesh.indices), mesh.count, *accessors.back());
}

// By mesh: 0 for the tile's own, else one of its own.
std::vector<std::size_t> groups_of_meshes(const Json& gltf) {
  std::vector<std::size_t> groups(gltf.at("meshes").size());
  for (const std::size_t mesh : instanced_meshes(gltf)) groups[mesh] = mesh + 1;
  return groups;
}

// The number of each primitive's mesh, in the order of primitives_of.
std::vector<std::size_t> mesh_numbers(const Json& gltf) {
  std::vector<std::size_t> numbers;
  if (!gltf.contains("meshes")) return numbers;
  for (std::size_t m = 0; m < gltf["meshes"].size(); ++m)
    numbers.insert(numbers.end(), gltf["meshes"][m]["primitives"].size(), m);
  return numbers;
}

// The arrays of a primitive, with positions and uvs in their planned steps.
MeshArrays stepped(const GlbParts& plain, const NarrowPlan& plan, std::size_t mesh, const Json& primitive) {
  MeshArrays arrays = arrays_of(plain, primitive);
  narrow_steps(plan, mesh, primitive.at("material").get<std::size_t>(), arrays);
  return arrays;
}

MeshArrays narrowed(const GlbParts& plain, const NarrowPlan& plan, std::size_t mesh, const Json& primitive) {
  MeshArrays arrays = stepped(plain, plan, mesh, primitive);
  narrow_directions(arrays);
  return arrays;
}

SharedViews shared_views(std::vector<MeshoptMesh>&& meshes, const std::vector<Json*>& primitives, GlbParts& packed) {
  const std::vector<std::size_t> mesh_of = mesh_numbers(packed.gltf), groups = groups_of_meshes(packed.gltf);
  SharedViews views;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    add_meshopt(std::move(meshes[i]), groups[mesh_of[i]], *primitives[i], packed, views);
  return views;
}

std::vector<MeshoptMesh> meshopt_meshes(const GlbParts& plain, const NarrowPlan& plan,
                                        const std::vector<Json*>& primitives, int threads) {
  const std::vector<std::size_t> mesh_of = mesh_numbers(plain.gltf);
  return for_each_slot<MeshoptMesh>(primitives.size(), threads, [&](std::size_t i) {
    const Json& indices = plain.gltf["accessors"].at(primitives[i]->at("indices").get<std::size_t>());
    return meshopt_arrays(stepped(plain, plan, mesh_of[i], *primitives[i]), bytes_of(component_of(indices)));
  });
}

void compress_meshopt(const GlbParts& plain, GlbParts& packed, int threads) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const NarrowPlan plan = plan_narrowing(plain);
  SharedViews views = shared_views(meshopt_meshes(plain, plan, primitives, threads), primitives, packed);
  std::vector<const SharedView*> shared;
  for (const auto& [key, view] : views.attributes) shared.push_back(&view);
  for (const SharedView& view : views.indices) shared.push_back(&view);
  const auto encoded = for_each_slot<MeshoptView>(
      shared.size(), threads, [&](std::size_t i) { return encode_meshopt(shared[i]->array, shared[i]->vertices); });
  std::size_t fallback_bytes = 0;
  for (std::size_t i = 0; i < encoded.size(); ++i) {
    const std::size_t number = add_meshopt_view(encoded[i], packed, fallback_bytes);
    for (Json* accessor : shared[i]->accessors) (*accessor)["bufferView"] = number;
  }
  packed.gltf["buffers"].push_back(
      {{"byteLength", fallback_bytes}, {"extensions", {{kMeshoptExtension, {{"fallback", true}}}}}});
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

// One primitive after the other: all narrow arrays at once would be as large as the file.
void quantise_attributes(const GlbParts& plain, bool has_exact_positions, GlbParts& packed) {
  const std::vector<Json*> primitives = primitives_of(packed.gltf);
  const std::vector<std::size_t> mesh_of = mesh_numbers(plain.gltf);
  NarrowPlan plan = plan_narrowing(plain);
  if (has_exact_positions) plan.positions.assign(plan.positions.size(), std::nullopt);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const MeshArrays narrow = narrowed(plain, plan, mesh_of[i], *primitives[i]);
    const std::vector<Json*> accessors = accessors_of(packed.gltf, *primitives[i]);
    for (std::size_t a = 0; a < narrow.attributes.size(); ++a)
      add_narrow_attribute(narrow.attributes[a], *accessors[a], packed);
    copy_view(plain, *accessors.back(), packed);
  }
  scale_by_plan(plan, packed);
}

// ---- Draco ---------------------------------------------------------------------------------------------------------

void add_draco(const DracoMesh& mesh, Json& primitive, GlbParts& packed) {
  Json ids = Json::object();
  std::size_t i = 0;
  for (const auto& [name, number] : primitive.at("attributes").items()) ids[name] = mesh.ids[i++];
  primitive["extensions"][kDracoExtension] = {{"bufferView", add_view(packed, mesh.bytes)}, {"attributes", ids}};
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

}  // namespace

GlbParts compressed_glb(GlbParts plain, Compression compression, int threads) {
  assert(compression != Compression::kNone);
  GlbParts packed{plain.gltf, {}};
  if (primitives_of(packed.gltf).empty()) return plain;
  // large, and should not move while it grows
  packed.buffer.reserve(plain.buffer.size());
  copy_other_views(plain, packed);
  if (compression == Compression::kDraco) {
    compress_draco(plain, packed, threads);
    demand(packed.gltf, kDracoExtension);
  } else if (compression == Compression::kMeshopt) {
    compress_meshopt(plain, packed, threads);
    demand(packed.gltf, kMeshoptExtension), demand(packed.gltf, kQuantizationExtension);
  } else {
    quantise_attributes(plain, compression == Compression::kLean, packed);
    demand(packed.gltf, kQuantizationExtension);
  }
  return packed;
}

}  // namespace citykiln::exporters
