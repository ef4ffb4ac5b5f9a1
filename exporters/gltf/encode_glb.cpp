#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "exporters/file.h"
#include "exporters/gltf/compress_glb.h"
#include "exporters/gltf/encode_materials.h"
#include "exporters/gltf/encode_pictures.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/glb_axes.h"
#include "exporters/gltf/glb_builder.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/quantise.h"
#include "exporters/gltf/tangents.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Float3;
using bake::Float4;
using bake::InstancedMesh;
using bake::Primitive;
using tinygltf::Value;
using Object = Value::Object;
using Array = Value::Array;

Value text(const std::string& s) { return Value(s); }
Value number(double v) { return Value(v); }
Value whole(std::size_t v) { return Value(static_cast<int>(v)); }

int add_positions(GlbBuilder& f, const std::vector<Float3>& positions) {
  const int accessor = f.add_turned(positions, TINYGLTF_TYPE_VEC3);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> low(3, kFar), high(3, -kFar);
  for (const Float3& position : positions) {
    const Float3 p = to_gltf(position);
    for (std::size_t c = 0; c < 3; ++c)
      low[c] = std::min<double>(low[c], p[c]), high[c] = std::max<double>(high[c], p[c]);
  }
  f.model.accessors.back().minValues = low, f.model.accessors.back().maxValues = high;
  return accessor;
}

int add_indices(GlbBuilder& f, const Primitive& p) {
  constexpr int kTarget = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
  const std::size_t count = p.triangles.size() * 3;
  if (p.positions.size() >= 65535)
    return f.add_accessor(f.add_view(p.triangles, kTarget), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                          count);
  const auto narrow = [](const auto& t) {
    return std::array{static_cast<std::uint16_t>(t[0]), static_cast<std::uint16_t>(t[1]),
                      static_cast<std::uint16_t>(t[2])};
  };
  return f.add_accessor(f.add_view_of(p.triangles, kTarget, narrow), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                        TINYGLTF_TYPE_SCALAR, count);
}

// A feature id extension: the attribute _FEATURE_ID_0 indexes rows of property table 0.
Value feature_ids(GlbBuilder& f, const char* extension) {
  f.extensions.insert(extension);
  const Object ids = {
      {"featureCount", whole(f.tile.features.size())}, {"attribute", Value(0)}, {"propertyTable", Value(0)}};
  return Value(Object{{"featureIds", Value(Array{Value(ids)})}});
}

tinygltf::Primitive primitive_of(GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  tinygltf::Primitive out;
  out.mode = TINYGLTF_MODE_TRIANGLES;
  const MaterialKey key = material_key_of(f, p, cutout);
  out.material = material_number(f, key);
  out.attributes["POSITION"] = add_positions(f, p.positions);
  out.attributes["NORMAL"] = f.add_turned(p.normals, TINYGLTF_TYPE_VEC3);
  out.attributes["COLOR_0"] = f.add_attribute(p.colours, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4,
                                              TINYGLTF_TARGET_ARRAY_BUFFER, true);
  if (!p.uvs.empty()) out.attributes["TEXCOORD_0"] = add_uvs(f, p, key);
  if (normals_of(f, key) != nullptr) out.attributes["TANGENT"] = f.add_turned(tangents_of(p), TINYGLTF_TYPE_VEC4);
  if (!p.features.empty()) {
    out.attributes["_FEATURE_ID_0"] = f.add_as_floats(p.features);
    out.extensions["EXT_mesh_features"] = feature_ids(f, "EXT_mesh_features");
  }
  out.indices = add_indices(f, p);
  return out;
}

int add_mesh(GlbBuilder& f, const std::string& name, const std::vector<Primitive>& primitives,
             const impostor::Cutout* cutout = nullptr) {
  tinygltf::Mesh mesh;
  mesh.name = name;
  for (const Primitive& p : primitives) mesh.primitives.push_back(primitive_of(f, p, cutout));
  f.model.meshes.push_back(std::move(mesh));
  return static_cast<int>(f.model.meshes.size()) - 1;
}

int add_node(GlbBuilder& f, tinygltf::Node node) {
  f.model.nodes.push_back(std::move(node));
  return static_cast<int>(f.model.nodes.size()) - 1;
}

// Adds all instances as one node, with their placements as attributes.
void add_extended(GlbBuilder& f, const InstancedMesh& instanced, int mesh, std::vector<int>& children) {
  tinygltf::Node node;
  node.name = instanced.name, node.mesh = mesh;
  std::vector<Float3> scales;
  for (const float s : instanced.scales) scales.push_back({s, s, s});
  const Object attributes = {
      {"TRANSLATION", Value(f.add_turned(instanced.translations, TINYGLTF_TYPE_VEC3, 0))},
      {"ROTATION", Value(f.add_turned(instanced.rotations, TINYGLTF_TYPE_VEC4, 0))},
      {"SCALE", Value(f.add_attribute(scales, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, 0))},
      {"_FEATURE_ID_0", Value(f.add_as_floats(instanced.features, 0))}};
  node.extensions["EXT_mesh_gpu_instancing"] = Value(Object{{"attributes", Value(attributes)}});
  node.extensions["EXT_instance_features"] = feature_ids(f, "EXT_instance_features");
  f.extensions.insert("EXT_mesh_gpu_instancing");
  children.push_back(add_node(f, std::move(node)));
}

// Adds one node per instance, all with one mesh.
void add_single_nodes(GlbBuilder& f, const InstancedMesh& instanced, int mesh, std::vector<int>& children) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    tinygltf::Node node;
    node.name = instanced.name, node.mesh = mesh;
    const Float3 t = to_gltf(instanced.translations[i]);
    const Float4 q = to_gltf(instanced.rotations[i]);
    node.translation = {t[0], t[1], t[2]}, node.rotation = {q[0], q[1], q[2], q[3]};
    node.scale.assign(3, instanced.scales[i]);
    node.extras = Value(Object{{"feature", whole(instanced.features[i])}});
    children.push_back(add_node(f, std::move(node)));
  }
}

// The OSM element of each feature; row 0 is none.
Value property_table(GlbBuilder& f) {
  std::vector<std::uint64_t> ids;
  std::vector<std::uint8_t> types;
  for (const OsmId& id : f.tile.features)
    ids.push_back(static_cast<std::uint64_t>(id.id)), types.push_back(static_cast<std::uint8_t>(id.type));
  const auto property = [](const char* name, const char* type, const char* what) {
    return Value(Object{
        {"name", text(name)}, {"description", text(what)}, {"type", text("SCALAR")}, {"componentType", text(type)}});
  };
  const Object osm = {{"id", property("OSM id", "UINT64", "id of the OpenStreetMap element")},
                      {"type", property("OSM type", "UINT8", "0 none, 1 node, 2 way, 3 relation")}};
  const Object schema = {{"id", text("citykiln")},
                         {"classes", Value(Object{{"osm", Value(Object{{"properties", Value(osm)}})}})}};
  const Object rows = {{"id", Value(Object{{"values", Value(f.add_view(ids, 0))}})},
                       {"type", Value(Object{{"values", Value(f.add_view(types, 0))}})}};
  const Object table = {
      {"name", text("osm")}, {"class", text("osm")}, {"count", whole(ids.size())}, {"properties", Value(rows)}};
  f.extensions.insert("EXT_structural_metadata");
  return Value(Object{{"schema", Value(schema)}, {"propertyTables", Value(Array{Value(table)})}});
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& t : texts) all += (all.empty() ? "" : "; ") + t;
  return all;
}

Value vector(Vec3 v) { return Value(Array{number(v.x), number(v.y), number(v.z)}); }

Value extras_of(const BakedTile& tile, const scene::Header& header) {
  const Object plane = {{"projection", text("transverse Mercator, WGS84, scale 1 at the origin")},
                        {"lon_0", number(header.origin.lon_deg)},
                        {"lat_0", number(header.origin.lat_deg)}};
  Object extras = {{"tile", Value(Array{Value(tile.tile.x), Value(tile.tile.y)})},
                   {"origin_m", vector(tile.origin)},
                   {"tolerance_m", number(tile.tolerance_m)},
                   {"error_m", number(tile.error_m)},
                   {"plant_error_m", number(tile.plant_error_m)},
                   {"rounding_m", number(rounding_m(tile.primitives))},
                   {"plane", Value(plane)}};
  if (const auto& seen = tile.viewpoint)
    extras["viewpoint"] = Value(Object{{"eye_m", vector(seen->eye)},
                                       {"focal_px", number(seen->focal_px)},
                                       {"pixel_error", number(seen->pixel_error)}});
  return Value(std::move(extras));
}

tinygltf::Node root_of(const BakedTile& tile, const scene::Header& header) {
  tinygltf::Node root;
  root.name = "tile_" + std::to_string(tile.tile.x) + "_" + std::to_string(tile.tile.y);
  // whole metres, so that tiles imported side by side fit exactly
  root.translation = {tile.origin.x, tile.origin.z, 0.0 - tile.origin.y};
  root.extras = extras_of(tile, header);
  return root;
}

void fill(GlbBuilder& f, Instancing instancing) {
  f.model.asset.version = "2.0", f.model.asset.generator = "citykiln 0.1.0",
  f.model.asset.copyright = joined(f.header.attributions);
  f.model.buffers.emplace_back();
  add_node(f, root_of(f.tile, f.header));
  if (!f.tile.primitives.empty()) f.model.nodes[0].mesh = add_mesh(f, "tile", f.tile.primitives);
  std::vector<int> children;
  for (const InstancedMesh& instanced : f.tile.instanced) {
    const int mesh = add_mesh(f, instanced.name, instanced.primitives, cutout_like(f, instanced.cutout));
    instancing == Instancing::kExtension ? add_extended(f, instanced, mesh, children)
                                         : add_single_nodes(f, instanced, mesh, children);
  }
  f.model.nodes[0].children = children;
  add_pictures(f);
  f.model.extensions["EXT_structural_metadata"] = property_table(f);
  f.model.extensionsUsed.assign(f.extensions.begin(), f.extensions.end());
  if (f.extensions.contains(kWebpExtension)) f.model.extensionsRequired = {kWebpExtension};
  tinygltf::Scene scene;
  scene.nodes = {0};
  f.model.scenes.push_back(scene);
  f.model.defaultScene = 0;
}

// An upper bound of the meshes' bytes in the buffer, which is large and should not move while it grows.
std::size_t bytes_of_meshes(const std::vector<Primitive>& primitives) {
  constexpr std::size_t kVertexBytes = 64, kTriangleBytes = 12, kPaddingBytes = 64;
  std::size_t bytes = 0;
  for (const Primitive& p : primitives)
    bytes += p.positions.size() * kVertexBytes + p.triangles.size() * kTriangleBytes + kPaddingBytes;
  return bytes;
}

GlbParts plain_parts(const BakedTile& tile, const scene::Header& header, Instancing instancing) {
  GlbBuilder f{tile, header};
  f.buffer.reserve(bytes_of_meshes(tile.primitives));
  find_cutouts(f);
  fill(f, instancing);
  std::ostringstream out;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&f.model, out, false, true);
  const std::string without_buffer = std::move(out).str();
  return {nlohmann::json::parse(json_of_glb(std::as_bytes(std::span(without_buffer)))), std::move(f.buffer)};
}

}  // namespace

std::vector<std::byte> encode_glb(const BakedTile& tile, const scene::Header& header, Instancing instancing,
                                  Compression compression, int threads) {
  if (compression == Compression::kNone) return join_glb(plain_parts(tile, header, instancing));
  return compressed_glb(plain_parts(quantised(tile), header, instancing), compression, threads);
}

Result<Done> write_glb(const BakedTile& tile, const scene::Header& header, Instancing instancing,
                       const std::string& path, Compression compression, int threads) {
  return write_file(path, encode_glb(tile, header, instancing, compression, threads));
}

}  // namespace citykiln::exporters
