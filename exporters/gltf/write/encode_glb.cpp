#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <utility>

#include "compiler/bake/far/bake_surroundings.h"
#include "exporters/file.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/pack/compress_glb.h"
#include "exporters/gltf/pack/quantise.h"
#include "exporters/gltf/split_buildings.h"
#include "exporters/gltf/write/encode_lights.h"
#include "exporters/gltf/write/encode_meshes.h"
#include "exporters/gltf/write/encode_pictures.h"
#include "exporters/gltf/write/glb_builder.h"
#include "exporters/gltf/write/property_table.h"
#include "exporters/joined_attributions.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Primitive;
using Json = nlohmann::json;

using bake::Float3;
using bake::InstancedMesh;
using bake::Layer;

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

// Returns the number with the fewest digits that reads as the same float: half of the digits of the float itself.
double in_few_digits(float value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = 0;
  std::from_chars(text.data(), end, number);
  return number;
}

template <std::size_t kSize>
Json in_few_digits(const std::array<float, kSize>& values) {
  Json numbers = Json::array();
  for (const float value : values) numbers.push_back(in_few_digits(value));
  return numbers;
}

// The extras of an instance. Only the first one of a feature has its tags: the plants of a garden would repeat those
// of its house.
Json extras_of_instance(GlbBuilder& f, std::uint32_t feature) {
  Json extras = extras_of(f.tile, feature);
  if (!f.instanced_features.insert(feature).second) extras.erase("tags"), extras.erase("assumed");
  return extras;
}

// Adds one node per instance, all with one mesh.
void add_single_nodes(GlbBuilder& f, const InstancedMesh& instanced, Json node, Json& parent) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    node["translation"] = in_few_digits(to_gltf(instanced.translations[i]));
    node["rotation"] = in_few_digits(to_gltf(instanced.rotations[i]));
    node["scale"] = Json(3, in_few_digits(instanced.scales[i]));
    node["extras"] = extras_of_instance(f, instanced.features[i]);
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

// Adds the root and all nodes below it, by the options' split and target:
//
//     tile_3_-2                        NodeSplit::kLayer
//     ├── ground, roads, water         a mesh each
//     ├── buildings                    a mesh, or with NodeSplit::kBuilding a node per building: way_1234
//     ├── structures                   a mesh
//     ├── props                        a mesh, and a node per lamp
//     └── plants                       a mesh, and a node per plant: oak_3
//
// With NodeSplit::kTile the root has the only mesh that is not instanced. Empty layers are left out. Meshes are
// numbered in the order of nodes; the instances of a mesh follow each other.
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

// Adds the meaning of the tile's coordinates.
void add_frame(Json& extras, const BakedTile& tile, const scene::Header& header, bool is_on_ellipsoid) {
  if (tile.cylinder) {
    extras["frame"] = {{"projection", "none: inside of a cylinder around the x axis at height radius_m"},
                       {"radius_m", tile.cylinder->radius_m},
                       {"middle_y_m", tile.cylinder->middle_y_m}};
    return;
  }
  extras[is_on_ellipsoid ? "frame" : "plane"] = {
      {"lon_0", header.origin.lon_deg},
      {"lat_0", header.origin.lat_deg},
      {"projection", is_on_ellipsoid ? "none: east, north, up at lon_0, lat_0 on the WGS84 ellipsoid"
                                     : "transverse Mercator, WGS84, scale 1 at the origin"}};
}

Json tile_extras(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  Json extras = {{"tile", {tile.tile.x, tile.tile.y}},  {"origin_m", {tile.origin.x, tile.origin.y, tile.origin.z}},
                 {"tolerance_m", tile.tolerance_m},     {"error_m", tile.error_m},
                 {"plant_error_m", tile.plant_error_m}, {"rounding_m", rounding_m(tile.primitives)}};
  add_frame(extras, tile, header, options.is_on_ellipsoid);
  if (const auto& seen = tile.viewpoint)
    extras["viewpoint"] = {{"eye_m", {seen->eye.x, seen->eye.y, seen->eye.z}},
                           {"focal_px", seen->focal_px},
                           {"pixel_error", seen->pixel_error}};
  return extras;
}

Json root_of(const BakedTile& tile, const scene::Header& header, const GlbOptions& options) {
  const bool is_around = tile.tile == bake::kSurroundingsTile;
  // whole metres, so that tiles imported side by side fit exactly
  return {{"name", is_around ? "surroundings" : fmt::format("tile_{}_{}", tile.tile.x, tile.tile.y)},
          {"translation", {tile.origin.x, tile.origin.z, 0.0 - tile.origin.y}},
          {"extras", tile_extras(tile, header, options)}};
}

void fill(GlbBuilder& f) {
  Json& gltf = f.file.gltf = new_gltf();
  const std::string copyright = joined_attributions(f.header.attributions);
  if (!copyright.empty()) gltf["asset"]["copyright"] = copyright;
  add_nodes(f, root_of(f.tile, f.header, f.options));
  add_lights(f);
  add_pictures(f);
  gltf["extensions"][kMetadataExtension] = property_table(f);
  gltf["extensionsUsed"] = f.extensions;
  if (f.extensions.contains(kWebpExtension)) gltf["extensionsRequired"] = Json::array({kWebpExtension});
}

// An upper bound of the meshes' bytes in the buffer, which is large and should not move while it grows.
std::size_t bytes_of_meshes(const std::vector<Primitive>& primitives) {
  constexpr std::size_t kVertexBytes = 64, kTriangleBytes = 12, kPaddingBytes = 64;
  std::size_t bytes = 0;
  for (const Primitive& p : primitives)
    bytes += p.positions.size() * kVertexBytes + p.triangles.size() * kTriangleBytes + kPaddingBytes;
  return bytes;
}

}  // namespace

GlbParts build_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options, int threads) {
  GlbBuilder f{tile, header, options};
  f.file.buffer.reserve(bytes_of_meshes(tile.primitives));
  find_cutouts(f);
  fill(f);
  if (options.compression == Compression::kNone) return std::move(f.file);
  return compressed_glb(std::move(f.file), options.compression, threads);
}

std::vector<std::byte> encode_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                                  int threads) {
  return join_glb(build_glb(tile, header, options, threads));
}

Result<Done> write_glb(const BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                       const std::string& path, int threads) {
  return write_file(path, encode_glb(tile, header, options, threads));
}

}  // namespace citykiln::exporters
