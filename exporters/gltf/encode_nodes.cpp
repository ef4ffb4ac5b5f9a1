#include "exporters/gltf/encode_nodes.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exporters/gltf/encode_meshes.h"
#include "exporters/gltf/encode_pictures.h"
#include "exporters/gltf/property_table.h"
#include "exporters/gltf/split_buildings.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Float4;
using bake::InstancedMesh;
using bake::Layer;
using bake::Primitive;
using tinygltf::Value;

int add_node(GlbBuilder& f, tinygltf::Node node) {
  f.model.nodes.push_back(std::move(node));
  return static_cast<int>(f.model.nodes.size()) - 1;
}

// Adds all instances as one node, with their placements as attributes.
void add_extended_node(GlbBuilder& f, const InstancedMesh& instanced, int mesh, std::vector<int>& parent) {
  tinygltf::Node node;
  node.name = instanced.name, node.mesh = mesh;
  std::vector<Float3> scales;
  for (const float s : instanced.scales) scales.push_back({s, s, s});
  const Value::Object attributes = {
      {"TRANSLATION", Value(f.add_turned(instanced.translations, TINYGLTF_TYPE_VEC3, 0))},
      {"ROTATION", Value(f.add_turned(instanced.rotations, TINYGLTF_TYPE_VEC4, 0))},
      {"SCALE", Value(f.add_attribute(scales, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, 0))},
      {"_FEATURE_ID_0", Value(f.add_as_floats(instanced.features, 0))}};
  node.extensions["EXT_mesh_gpu_instancing"] = Value(Value::Object{{"attributes", Value(attributes)}});
  node.extensions["EXT_instance_features"] = feature_ids(f, "EXT_instance_features");
  f.extensions.insert("EXT_mesh_gpu_instancing");
  parent.push_back(add_node(f, std::move(node)));
}

// Adds one node per instance, all with one mesh.
void add_single_nodes(GlbBuilder& f, const InstancedMesh& instanced, int mesh, std::vector<int>& parent) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    tinygltf::Node node;
    node.name = instanced.name, node.mesh = mesh;
    const Float3 t = to_gltf(instanced.translations[i]);
    const Float4 q = to_gltf(instanced.rotations[i]);
    node.translation = {t[0], t[1], t[2]}, node.rotation = {q[0], q[1], q[2], q[3]};
    node.scale.assign(3, instanced.scales[i]);
    node.extras = extras_of(f.tile, instanced.features[i]);
    parent.push_back(add_node(f, std::move(node)));
  }
}

// Adds an instanced mesh, whose nodes become children of a parent.
void add_instances(GlbBuilder& f, const InstancedMesh& instanced, std::vector<int>& parent) {
  const int mesh = add_mesh(f, instanced.name, instanced.primitives, cutout_like(f, *instanced.cutout));
  const bool is_extended = values_of(f.options.target).instancing == Instancing::kExtension;
  is_extended ? add_extended_node(f, instanced, mesh, parent) : add_single_nodes(f, instanced, mesh, parent);
}

// Adds the layer's own mesh, of what cannot be split, and a node per building.
void add_buildings(GlbBuilder& f, std::span<const Primitive> primitives, tinygltf::Node& layer) {
  const SplitBuildings split = split_buildings(primitives);
  if (!split.rest.empty()) layer.mesh = add_mesh(f, layer.name, split.rest);
  for (const auto& [feature, building] : split.buildings) {
    tinygltf::Node node;
    node.name = feature_name(f.tile, feature), node.extras = extras_of(f.tile, feature);
    node.mesh = add_mesh(f, node.name, building);
    layer.children.push_back(add_node(f, std::move(node)));
  }
}

// Adds the node of a layer. Its own mesh comes before those of its children.
void add_layer_node(GlbBuilder& f, Layer layer, std::span<const Primitive> primitives,
                    std::span<const InstancedMesh> instanced) {
  tinygltf::Node node;
  node.name = name_of(layer);
  const int number = add_node(f, node);
  f.model.nodes[0].children.push_back(number);
  if (f.options.split == Split::kBuilding && layer == Layer::kBuildings)
    add_buildings(f, primitives, node);
  else if (!primitives.empty())
    node.mesh = add_mesh(f, node.name, primitives);
  for (const InstancedMesh& each : instanced) add_instances(f, each, node.children);
  f.model.nodes[static_cast<std::size_t>(number)] = std::move(node);
}

void add_layers(GlbBuilder& f) {
  std::span<const Primitive> primitives = f.tile.primitives;
  std::span<const InstancedMesh> instanced = f.tile.instanced;
  for (int i = 0; i < static_cast<int>(Layer::kCount); ++i) {
    const auto layer = static_cast<Layer>(i);
    const auto own = std::ranges::find_if(primitives, [&](const auto& p) { return p.layer != layer; });
    const auto own_instanced = std::ranges::find_if(instanced, [&](const auto& m) { return layer_of(m) != layer; });
    const auto count = static_cast<std::size_t>(own - primitives.begin()),
               instanced_count = static_cast<std::size_t>(own_instanced - instanced.begin());
    if (count + instanced_count > 0)
      add_layer_node(f, layer, primitives.first(count), instanced.first(instanced_count));
    primitives = primitives.subspan(count), instanced = instanced.subspan(instanced_count);
  }
  assert(primitives.empty() && instanced.empty() && "sorted by layer");
}

}  // namespace

void add_nodes(GlbBuilder& f, tinygltf::Node root) {
  add_node(f, std::move(root));
  if (f.options.split != Split::kTile) return add_layers(f);
  if (!f.tile.primitives.empty()) f.model.nodes[0].mesh = add_mesh(f, "tile", f.tile.primitives);
  std::vector<int> children;
  for (const InstancedMesh& instanced : f.tile.instanced) add_instances(f, instanced, children);
  f.model.nodes[0].children = std::move(children);
}

}  // namespace citykiln::exporters
