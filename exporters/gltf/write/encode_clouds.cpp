#include "exporters/gltf/write/encode_clouds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "exporters/gltf/write/encode_meshes.h"
#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using Json = nlohmann::json;

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

std::vector<Float3> narrowed_from(const std::vector<Vec3>& vectors, Vec3 origin) {
  std::vector<Float3> narrow;
  narrow.reserve(vectors.size());
  for (const Vec3 v : vectors) narrow.push_back(bake::narrowed(v - origin));
  return narrow;
}

std::size_t add_opacity(GlbBuilder& f, const sky::CloudSurface& part) {
  return f.add_attribute(part.opacity, ViewUse::kVertices, [](double opacity) {
    return materials::Tint{255, 255, 255, static_cast<std::uint8_t>(std::lround(opacity * 255))};
  });
}

std::size_t add_cloud_indices(GlbBuilder& f, const sky::CloudSurface& part) {
  return f.add_accessor(f.add_view(part.triangles, ViewUse::kIndices), Component::kUnsignedInt, 1,
                        3 * part.triangles.size());
}

std::size_t add_cloud_material(GlbBuilder& f, bool is_thin) {
  Json material = {{"name", is_thin ? "ThinCloud" : "Cloud"},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {kCloudAlbedo, kCloudAlbedo, kCloudAlbedo, 1.0}}, {"metallicFactor", 0.0}}}};
  if (is_thin) material["alphaMode"] = "BLEND";
  return f.add("materials", std::move(material));
}

std::size_t add_cloud_part(GlbBuilder& f, const sky::CloudSurface& part, const std::string& name, std::size_t material,
                           bool is_thin, Vec3 origin) {
  Json primitive = {{"mode", kTrianglesMode}, {"material", material}};
  Json& attributes = primitive["attributes"];
  attributes["POSITION"] = add_positions(f, narrowed_from(part.positions, origin));
  attributes["NORMAL"] = f.add_turned(narrowed_from(part.normals, {}), ViewUse::kVertices);
  if (is_thin) attributes["COLOR_0"] = add_opacity(f, part);
  primitive["indices"] = add_cloud_indices(f, part);
  const std::size_t mesh = f.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
  return f.add("nodes", {{"name", name}, {"mesh", mesh}});
}

// Returns the number of the layer's node, which comes before those of its parts.
std::size_t add_cloud_layer(GlbBuilder& f, const CloudMeshes& layer, std::size_t same_before, Vec3 origin) {
  std::string name(sky::name_of(layer.layer.kind));
  if (same_before > 0) name += fmt::format("_{}", same_before + 1);
  Json node = {{"name", name},
               {"extras",
                {{"kind", sky::name_of(layer.layer.kind)},
                 {"cover", layer.layer.cover},
                 {"base_m", layer.layer.base_m},
                 {"top_m", layer.layer.top_m},
                 {"clouds", layer.clouds}}}};
  const std::size_t number = f.add("nodes", nullptr);
  const bool is_thin = sky::is_thin(layer.layer);
  const std::size_t material = add_cloud_material(f, is_thin);
  for (std::size_t i = 0; i < layer.parts.size(); ++i)
    node["children"].push_back(
        add_cloud_part(f, layer.parts[i], fmt::format("{}_part_{}", name, i + 1), material, is_thin, origin));
  f.file.gltf["nodes"][number] = std::move(node);
  return number;
}

// A cell's diagonal in the layer's frame, in plane metres: cirrus is stretched along the wind.
double surface_error_m(std::span<const CloudMeshes> layers, double cell_m) {
  constexpr double kDiagonal = 1.7320508075688772;
  double stretch = 1;
  for (const CloudMeshes& layer : layers) stretch = std::max(stretch, sky::frame_of(layer.layer).stretch);
  return cell_m * kDiagonal * stretch;
}

Json plane_of(const scene::Header& header) {
  return {{"lon_0", header.origin.lon_deg},
          {"lat_0", header.origin.lat_deg},
          {"projection", "transverse Mercator, WGS84, scale 1 at the origin"}};
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
  f.file.gltf = new_gltf();
  const Vec3 origin = whole_metres_near(layers);
  Json root = {{"name", "clouds"},
               {"translation", {origin.x, origin.z, 0.0 - origin.y}},
               {"extras",
                {{"cell_m", cell_m},
                 {"error_m", surface_error_m(layers, cell_m)},
                 {"particle_m", particle_m},
                 {frame.empty() ? "plane" : "frame", frame.empty() ? plane_of(header) : Json(frame)}}}};
  f.add("nodes", nullptr);
  for (std::size_t i = 0; i < layers.size(); ++i)
    root["children"].push_back(add_cloud_layer(f, layers[i], same_before(layers, i), origin));
  f.file.gltf["nodes"][0] = std::move(root);
  return join_glb(std::move(f.file));
}

}  // namespace citykiln::exporters
