#include "exporters/gltf/write/encode_meshes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

#include "exporters/gltf/flat_shading.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/object_runs.h"
#include "exporters/gltf/plant_tints.h"
#include "exporters/gltf/write/encode_materials.h"
#include "exporters/gltf/write/tangents.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;
using Json = nlohmann::json;

// So many vertices can be numbered in 16 bits; 65535 is reserved.
constexpr std::size_t kMostVertices = 65535;

std::size_t add_indices(GlbBuilder& f, const Primitive& p) {
  const std::size_t count = p.triangles.size() * 3;
  if (p.positions.size() > kMostVertices)
    return f.add_accessor(f.add_view(p.triangles, ViewUse::kIndices), Component::kUnsignedInt, 1, count);
  const auto narrow = [](const auto& t) {
    return std::array{static_cast<std::uint16_t>(t[0]), static_cast<std::uint16_t>(t[1]),
                      static_cast<std::uint16_t>(t[2])};
  };
  return f.add_accessor(f.add_view(p.triangles, ViewUse::kIndices, narrow), Component::kUnsignedShort, 1, count);
}

std::size_t add_colours(GlbBuilder& f, const Primitive& p, const materials::Tint& largest) {
  return f.add_attribute(p.colours, ViewUse::kVertices,
                         [&](const materials::Tint& tint) { return share_of(tint, largest); });
}

std::size_t add_tangents(GlbBuilder& f, const Primitive& front, bool has_backs) {
  std::vector<bake::Float4> tangents = tangents_of(front);
  const std::size_t count = tangents.size();
  // back sides have the tangents and normals of their fronts
  for (std::size_t i = 0; has_backs && i < count; ++i) tangents.push_back(bake::Float4{tangents[i]});
  return f.add_turned(tangents, ViewUse::kVertices);
}

Json encoded_primitive(GlbBuilder& f, const Primitive& front, const impostor::Cutout* cutout) {
  const MaterialKey key = material_key_of(f, front, cutout);
  Json out = {{"mode", kTrianglesMode}, {"material", material_number(f, key)}};
  const std::optional<Primitive> both = key.has_backs ? std::optional(with_backs(front)) : std::nullopt;
  const Primitive& p = both ? *both : front;
  Json& attributes = out["attributes"];
  attributes["POSITION"] = add_positions(f, p.positions);
  if (!p.normals.empty()) attributes["NORMAL"] = f.add_turned(p.normals, ViewUse::kVertices);
  attributes["COLOR_0"] = add_colours(f, p, key.tint);
  if (!p.uvs.empty()) attributes["TEXCOORD_0"] = add_uvs(f, p, key);
  if (normals_of(f, key) != nullptr) attributes["TANGENT"] = add_tangents(f, front, key.has_backs);
  if (!p.features.empty()) {
    attributes["_FEATURE_ID_0"] = f.add_as_floats(p.features, ViewUse::kVertices);
    out["extensions"]["EXT_mesh_features"] = feature_ids(f, "EXT_mesh_features");
  }
  out["indices"] = add_indices(f, p);
  return out;
}

// Packed positions are rounded, so that faces lean.
bool needs_no_normals(const GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  if (!values_of(f.options.target).shades_flat || f.options.compression != Compression::kNone) return false;
  const MaterialKey key = material_key_of(f, p, cutout);
  return !key.has_backs && normals_of(f, key) == nullptr && is_flat(p);
}

// Calls add(part) for parts with at most kMostVertices each, where objects allow.
template <typename Add>
void for_each_part(const Primitive& p, Add add) {
  if (p.positions.size() <= kMostVertices) return add(p);
  for (const ObjectRun& run : joined_runs(object_runs(p), kMostVertices)) add(part_of(p, run));
}

Json layer_extras(bake::Layer layer) { return {{"layer", name_of(layer)}}; }

}  // namespace

std::size_t add_mesh(GlbBuilder& f, const std::string& name, std::span<const Primitive> primitives,
                     const impostor::Cutout* cutout) {
  assert(!primitives.empty());
  const bake::Layer layer = primitives.front().layer;
  const bool is_one_layer = std::ranges::all_of(primitives, [&](const Primitive& p) { return p.layer == layer; });
  Json mesh = {{"name", name}};
  if (is_one_layer) mesh["extras"] = layer_extras(layer);
  const auto add = [&](const Primitive& p) {
    Json primitive = encoded_primitive(f, p, cutout);
    if (!is_one_layer) primitive["extras"] = layer_extras(p.layer);
    mesh["primitives"].push_back(std::move(primitive));
  };
  for (const Primitive& p : primitives) {
    if (needs_no_normals(f, p, cutout))
      for_each_part(without_normals(Primitive(p)), add);
    else
      for_each_part(p, add);
  }
  return f.add("meshes", std::move(mesh));
}

std::size_t add_positions(GlbBuilder& f, const std::vector<Float3>& positions) {
  const std::size_t accessor = f.add_turned(positions, ViewUse::kVertices);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const Float3& position : positions) {
    const Float3 p = to_gltf(position);
    for (std::size_t c = 0; c < 3; ++c)
      low[c] = std::min<double>(low[c], p[c]), high[c] = std::max<double>(high[c], p[c]);
  }
  Json& limits = f.file.gltf["accessors"][accessor];
  limits["min"] = low, limits["max"] = high;
  return accessor;
}

Json feature_ids(GlbBuilder& f, const char* extension) {
  f.extensions.insert(extension);
  return {{"featureIds",
           Json::array({{{"featureCount", f.tile.features.size()}, {"attribute", 0}, {"propertyTable", 0}}})}};
}

}  // namespace citykiln::exporters
