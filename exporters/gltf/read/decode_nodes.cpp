#include "exporters/gltf/read/decode_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/read/decode_pictures.h"
#include "exporters/gltf/read/decode_primitives.h"
#include "exporters/gltf/split_buildings.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Float3;
using bake::Float4;
using bake::InstancedMesh;
using bake::Primitive;
using tinygltf::Value;

void read_extended_instances(GltfReader& reader, const tinygltf::Node& node, std::size_t features, InstancedMesh& out) {
  const Value& attributes = member(node.extensions.at(kInstancingExtension), "attributes");
  const auto accessor = [&](const char* name) { return whole(member(attributes, name)); };
  out.translations = turned(values_of<Float3>(reader, accessor("TRANSLATION")));
  out.rotations = turned(values_of<Float4>(reader, accessor("ROTATION")));
  for (const Float3& s : values_of<Float3>(reader, accessor("SCALE"))) out.scales.push_back(s[0]);
  out.features = as_numbers(values_of<float>(reader, accessor("_FEATURE_ID_0")), features);
  const std::size_t n = out.translations.size();
  expect(out.rotations.size() == n && out.scales.size() == n && out.features.size() == n,
         "as many values for each instance");
}

void add_single(const tinygltf::Node& node, std::size_t features, InstancedMesh& out) {
  expect(node.translation.size() == 3 && node.rotation.size() == 4 && node.scale.size() == 3,
         "a place for each instance");
  const auto f = [](double v) {
    expect(std::abs(v) <= std::numeric_limits<float>::max(), "places in single precision");
    return static_cast<float>(v);
  };
  const int feature = whole(member(node.extras, "feature"));
  expect(feature >= 0 && static_cast<std::size_t>(feature) < features, "feature ids inside the property table");
  out.translations.push_back(from_gltf(Float3{f(node.translation[0]), f(node.translation[1]), f(node.translation[2])}));
  out.rotations.push_back(
      from_gltf(Float4{f(node.rotation[0]), f(node.rotation[1]), f(node.rotation[2]), f(node.rotation[3])}));
  out.scales.push_back(f(node.scale[0]));
  out.features.push_back(static_cast<std::uint32_t>(feature));
}

bool is_light_group(const tinygltf::Node& node) { return node.name == kLightGroup && node.mesh < 0; }
bool is_extended(const tinygltf::Node& node) { return node.extensions.count(kInstancingExtension) != 0; }
// Layers and buildings lie where the tile does.
bool is_instance(const tinygltf::Node& node) { return is_extended(node) || !node.translation.empty(); }

// The tile while its nodes are read, in their order.
struct NodeReader {
  GltfReader& reader;
  BakedTile& tile;
  std::vector<std::optional<std::size_t>> cutouts{};  // one per entry of tile.instanced
  int last_mesh = -1, last_layer_node = 0;
  bool is_open = false;  // whether the next node may place the last mesh again

  const tinygltf::Node& node(int number) const { return item(reader.model.nodes, number, "a node that exists"); }

  std::vector<Primitive> next_mesh(int mesh) {
    expect(mesh > last_mesh, "each mesh in nodes that follow each other, in order");
    last_mesh = mesh, is_open = false;
    return primitives_of(reader, mesh, tile.features.size());
  }

  void add_static(int mesh) {
    for (Primitive& p : next_mesh(mesh)) {
      expect(tile.primitives.empty() || tile.primitives.back().layer <= p.layer, "layers in their order");
      tile.primitives.push_back(std::move(p));
    }
  }

  // Checks a mesh that was added, and finds its cutout.
  void accept_instanced(const tinygltf::Node& node) {
    const std::vector<Primitive>& primitives = tile.instanced.back().primitives;
    const bake::Layer layer = layer_of(tile.instanced.back());
    expect(std::ranges::all_of(primitives, [&](const Primitive& p) { return p.layer == layer; }),
           "one layer in each instanced mesh");
    const std::size_t others = tile.instanced.size() - 1;
    expect(others == 0 || layer_of(tile.instanced[others - 1]) <= layer, "layers in their order");
    cutouts.push_back(cutout_image_of(reader.model, node.mesh));
  }

  void add_instance(const tinygltf::Node& node) {
    if (is_open && !is_extended(node) && node.mesh == last_mesh)
      return add_single(node, tile.features.size(), tile.instanced.back());
    tile.instanced.push_back({.name = node.name, .primitives = next_mesh(node.mesh)});
    accept_instanced(node);
    if (is_extended(node)) return read_extended_instances(reader, node, tile.features.size(), tile.instanced.back());
    is_open = true;
    add_single(node, tile.features.size(), tile.instanced.back());
  }

  // Joins the primitives of a building to those of the buildings before it, from `first` on.
  void add_building(const tinygltf::Node& node, std::size_t first) {
    for (const Primitive& p : next_mesh(node.mesh)) {
      expect(p.layer == bake::Layer::kBuildings, "nodes of single buildings in their layer");
      const auto begin = tile.primitives.begin() + static_cast<std::ptrdiff_t>(first);
      const auto place = std::ranges::lower_bound(begin, tile.primitives.end(), key_of(p), {}, bake::key_of);
      if (place != tile.primitives.end() && key_of(*place) == key_of(p))
        append_primitive(*place, p);
      else
        tile.primitives.insert(place, p);
    }
  }

  void add_layer(int number) {
    expect(number > last_layer_node, "each layer once");
    last_layer_node = number;
    const tinygltf::Node& layer = node(number);
    if (layer.mesh >= 0) add_static(layer.mesh);
    const std::size_t first = tile.primitives.size();
    for (const int child : layer.children)
      is_instance(node(child)) ? add_instance(node(child)) : add_building(node(child), first);
  }
};

}  // namespace

std::vector<std::optional<std::size_t>> read_nodes(GltfReader& reader, BakedTile& tile) {
  NodeReader nodes{reader, tile};
  const tinygltf::Node& root = nodes.node(0);
  if (root.mesh >= 0) nodes.add_static(root.mesh);
  for (const int child : root.children) {
    if (is_light_group(nodes.node(child))) continue;
    is_instance(nodes.node(child)) ? nodes.add_instance(nodes.node(child)) : nodes.add_layer(child);
  }
  return std::move(nodes.cutouts);
}

}  // namespace citykiln::exporters
