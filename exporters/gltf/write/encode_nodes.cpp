#include "exporters/gltf/write/encode_nodes.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/split_buildings.h"
#include "exporters/gltf/write/encode_meshes.h"
#include "exporters/gltf/write/encode_pictures.h"
#include "exporters/gltf/write/property_table.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::InstancedMesh;
using bake::Layer;
using bake::Primitive;
using Json = nlohmann::json;

void add_child(GlbBuilder& f, Json node, Json& parent) {
  parent["children"].push_back(f.add("nodes", std::move(node)));
}

// Adds all instances as one node, with their placements as attributes.
void add_extended_node(GlbBuilder& f, const InstancedMesh& instanced, Json node, Json& parent) {
  const auto thrice = [](float s) { return Float3{s, s, s}; };
  Json& extensions = node["extensions"];
  Json& attributes = extensions[kInstancingExtension]["attributes"];
  attributes["TRANSLATION"] = f.add_turned(instanced.translations, ViewUse::kOther);
  attributes["ROTATION"] = f.add_turned(instanced.rotations, ViewUse::kOther);
  attributes["SCALE"] = f.add_attribute(instanced.scales, ViewUse::kOther, thrice);
  attributes["_FEATURE_ID_0"] = f.add_as_floats(instanced.features, ViewUse::kOther);
  extensions["EXT_instance_features"] = feature_ids(f, "EXT_instance_features");
  f.extensions.insert(kInstancingExtension);
  add_child(f, std::move(node), parent);
}

// Adds one node per instance, all with one mesh.
void add_single_nodes(GlbBuilder& f, const InstancedMesh& instanced, Json node, Json& parent) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    node["translation"] = to_gltf(instanced.translations[i]), node["rotation"] = to_gltf(instanced.rotations[i]);
    node["scale"] = Json(3, instanced.scales[i]);
    node["extras"] = extras_of(f.tile, instanced.features[i]);
    add_child(f, node, parent);
  }
}

// Adds an instanced mesh, whose nodes become children of a parent.
void add_instances(GlbBuilder& f, const InstancedMesh& instanced, Json& parent) {
  Json node = {{"name", instanced.name},
               {"mesh", add_mesh(f, instanced.name, instanced.primitives, cutout_like(f, *instanced.cutout))}};
  const bool is_extended = values_of(f.options.target).instancing == Instancing::kExtension;
  (is_extended ? add_extended_node : add_single_nodes)(f, instanced, std::move(node), parent);
}

// Adds the layer's own mesh, of what cannot be split, and a node per building.
void add_buildings(GlbBuilder& f, std::span<const Primitive> primitives, Json& layer) {
  const SplitBuildings split = split_buildings(primitives);
  if (!split.rest.empty()) layer["mesh"] = add_mesh(f, layer["name"], split.rest);
  for (const auto& [feature, building] : split.buildings) {
    const std::string name = feature_name(f.tile, feature);
    add_child(f, {{"name", name}, {"mesh", add_mesh(f, name, building)}, {"extras", extras_of(f.tile, feature)}},
              layer);
  }
}

// Adds the node of a layer. It and its own mesh come before its children and theirs.
void add_layer_node(GlbBuilder& f, Layer layer, std::span<const Primitive> primitives,
                    std::span<const InstancedMesh> instanced, Json& root) {
  Json node = {{"name", name_of(layer)}};
  const std::size_t number = f.add("nodes", nullptr);
  root["children"].push_back(number);
  if (f.options.split == NodeSplit::kBuilding && layer == Layer::kBuildings)
    add_buildings(f, primitives, node);
  else if (!primitives.empty())
    node["mesh"] = add_mesh(f, node["name"], primitives);
  for (const InstancedMesh& each : instanced) add_instances(f, each, node);
  f.file.gltf["nodes"][number] = std::move(node);
}

void add_layers(GlbBuilder& f, Json& root) {
  std::span<const Primitive> primitives = f.tile.primitives;
  std::span<const InstancedMesh> instanced = f.tile.instanced;
  for (int i = 0; i < static_cast<int>(Layer::kCount); ++i) {
    const auto layer = static_cast<Layer>(i);
    const auto own = std::ranges::find_if(primitives, [&](const auto& p) { return p.layer != layer; });
    const auto own_instanced = std::ranges::find_if(instanced, [&](const auto& m) { return layer_of(m) != layer; });
    const auto count = static_cast<std::size_t>(own - primitives.begin()),
               instanced_count = static_cast<std::size_t>(own_instanced - instanced.begin());
    if (count + instanced_count > 0)
      add_layer_node(f, layer, primitives.first(count), instanced.first(instanced_count), root);
    primitives = primitives.subspan(count), instanced = instanced.subspan(instanced_count);
  }
  assert(primitives.empty() && instanced.empty() && "sorted by layer");
}

}  // namespace

void add_nodes(GlbBuilder& f, Json root) {
  f.add("nodes", nullptr);
  if (f.options.split != NodeSplit::kTile) {
    add_layers(f, root);
  } else {
    if (!f.tile.primitives.empty()) root["mesh"] = add_mesh(f, "tile", f.tile.primitives);
    for (const InstancedMesh& instanced : f.tile.instanced) add_instances(f, instanced, root);
  }
  f.file.gltf["nodes"][0] = std::move(root);
}

}  // namespace citykiln::exporters
