#include "exporters/gltf/encode_clouds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>

#include "exporters/gltf/glb_builder.h"
#include "exporters/gltf/plain_glb.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using tinygltf::Value;

// Reflectance of a thick cloud: nearly all light leaves it again.
constexpr double kCloudAlbedo = 0.92;

Vec3 whole_metres_near(std::span<const CloudMeshes> layers) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const CloudMeshes& layer : layers)
    for (const sky::CloudSurface& part : layer.parts)
      for (const Vec3 p : part.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
  const Vec3 middle = (low + high) * 0.5;
  return {std::round(middle.x), std::round(middle.y), std::round(middle.z)};
}

// The smallest and largest coordinates, which POSITION must have.
void set_bounds(GlbBuilder& f, int accessor, const std::vector<Float3>& positions) {
  std::vector<double> low(3, 1e300), high(3, -1e300);
  for (const Float3& position : positions) {
    const Float3 p = to_gltf(position);
    for (std::size_t c = 0; c < 3; ++c)
      low[c] = std::min<double>(low[c], p[c]), high[c] = std::max<double>(high[c], p[c]);
  }
  f.model.accessors[static_cast<std::size_t>(accessor)].minValues = low;
  f.model.accessors[static_cast<std::size_t>(accessor)].maxValues = high;
}

int add_cloud_positions(GlbBuilder& f, const sky::CloudSurface& part, Vec3 origin) {
  std::vector<Float3> positions;
  positions.reserve(part.positions.size());
  for (const Vec3 p : part.positions) positions.push_back(bake::narrowed(p - origin));
  const int accessor = f.add_turned(positions, TINYGLTF_TYPE_VEC3);
  set_bounds(f, accessor, positions);
  return accessor;
}

int add_cloud_normals(GlbBuilder& f, const sky::CloudSurface& part) {
  std::vector<Float3> normals;
  normals.reserve(part.normals.size());
  for (const Vec3 n : part.normals) normals.push_back(bake::narrowed(n));
  return f.add_turned(normals, TINYGLTF_TYPE_VEC3);
}

int add_opacity(GlbBuilder& f, const sky::CloudSurface& part) {
  std::vector<std::array<std::uint8_t, 4>> colours;
  colours.reserve(part.opacity.size());
  for (const double opacity : part.opacity)
    colours.push_back({255, 255, 255, static_cast<std::uint8_t>(std::lround(opacity * 255))});
  return f.add_attribute(colours, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4,
                         TINYGLTF_TARGET_ARRAY_BUFFER, true);
}

int add_cloud_indices(GlbBuilder& f, const sky::CloudSurface& part) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * part.triangles.size());
  for (const auto& triangle : part.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  return f.add_attribute(indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                         TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
}

int add_cloud_material(GlbBuilder& f, bool is_thin) {
  tinygltf::Material material;
  material.name = is_thin ? "ThinCloud" : "Cloud";
  material.pbrMetallicRoughness.baseColorFactor = {kCloudAlbedo, kCloudAlbedo, kCloudAlbedo, 1};
  material.pbrMetallicRoughness.metallicFactor = 0, material.pbrMetallicRoughness.roughnessFactor = 1;
  if (is_thin) material.alphaMode = "BLEND";
  f.model.materials.push_back(material);
  return static_cast<int>(f.model.materials.size()) - 1;
}

int add_cloud_node(GlbBuilder& f, tinygltf::Node node, int parent) {
  f.model.nodes.push_back(std::move(node));
  const int number = static_cast<int>(f.model.nodes.size()) - 1;
  if (parent >= 0) f.model.nodes[static_cast<std::size_t>(parent)].children.push_back(number);
  return number;
}

void add_cloud_part(GlbBuilder& f, const sky::CloudSurface& part, const std::string& name, int material, bool is_thin,
                    Vec3 origin, int parent) {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES, primitive.material = material;
  primitive.attributes["POSITION"] = add_cloud_positions(f, part, origin);
  primitive.attributes["NORMAL"] = add_cloud_normals(f, part);
  if (is_thin) primitive.attributes["COLOR_0"] = add_opacity(f, part);
  primitive.indices = add_cloud_indices(f, part);
  tinygltf::Mesh mesh;
  mesh.name = name, mesh.primitives = {primitive};
  f.model.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = name, node.mesh = static_cast<int>(f.model.meshes.size()) - 1;
  add_cloud_node(f, std::move(node), parent);
}

void add_cloud_layer(GlbBuilder& f, const CloudMeshes& layer, std::size_t number, Vec3 origin) {
  tinygltf::Node node;
  node.name = sky::name_of(layer.layer.kind);
  if (number > 0) node.name += fmt::format("_{}", number + 1);
  node.extras = Value(Value::Object{{"kind", Value(std::string(sky::name_of(layer.layer.kind)))},
                                    {"cover", Value(layer.layer.cover)},
                                    {"base_m", Value(layer.layer.base_m)},
                                    {"top_m", Value(layer.layer.top_m)},
                                    {"clouds", Value(static_cast<int>(layer.clouds))}});
  const std::string name = node.name;
  const int own = add_cloud_node(f, std::move(node), 0);
  const bool is_thin = sky::is_thin(layer.layer);
  const int material = add_cloud_material(f, is_thin);
  for (std::size_t i = 0; i < layer.parts.size(); ++i)
    add_cloud_part(f, layer.parts[i], fmt::format("{}_part_{}", name, i + 1), material, is_thin, origin, own);
}

Value plane_of(const scene::Header& header) {
  return Value(Value::Object{{"lon_0", Value(header.origin.lon_deg)},
                             {"lat_0", Value(header.origin.lat_deg)},
                             {"projection", Value(std::string("transverse Mercator, WGS84, scale 1 at the origin"))}});
}

// Layers of the same kind before one.
std::size_t same_before(std::span<const CloudMeshes> layers, std::size_t i) {
  const auto is_same = [&](const CloudMeshes& other) { return other.layer.kind == layers[i].layer.kind; };
  return static_cast<std::size_t>(std::ranges::count_if(layers.first(i), is_same));
}

}  // namespace

std::vector<std::byte> encode_clouds(std::span<const CloudMeshes> layers, const scene::Header& header, double cell_m,
                                     double particle_m, const std::string& frame) {
  assert(std::ranges::any_of(layers, [](const CloudMeshes& layer) { return !layer.parts.empty(); }));
  const bake::BakedTile none;
  const GlbOptions options;
  GlbBuilder f{none, header, options};
  f.model.asset.version = "2.0", f.model.asset.generator = "citykiln 0.1.0";
  f.model.buffers.emplace_back();
  const Vec3 origin = whole_metres_near(layers);
  tinygltf::Node root;
  root.name = "clouds";
  root.translation = {origin.x, origin.z, 0.0 - origin.y};
  root.extras =
      Value(Value::Object{{"cell_m", Value(cell_m)},
                          {"error_m", Value(cell_m * 1.7320508075688772)},
                          {"particle_m", Value(particle_m)},
                          {frame.empty() ? "plane" : "frame", frame.empty() ? plane_of(header) : Value(frame)}});
  add_cloud_node(f, std::move(root), -1);
  for (std::size_t i = 0; i < layers.size(); ++i) add_cloud_layer(f, layers[i], same_before(layers, i), origin);
  tinygltf::Scene scene;
  scene.nodes = {0};
  f.model.scenes.push_back(scene), f.model.defaultScene = 0;
  std::ostringstream out;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&f.model, out, false, true);
  return joined_glb({std::move(out).str(), std::move(f.buffer)});
}

}  // namespace citykiln::exporters
