#include "exporters/gltf/encode_meshes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "exporters/gltf/encode_materials.h"
#include "exporters/gltf/tangents.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;
using tinygltf::Value;

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

Value layer_extras(bake::Layer layer) { return Value(Value::Object{{"layer", Value(std::string(name_of(layer)))}}); }

}  // namespace

int add_mesh(GlbBuilder& f, const std::string& name, std::span<const Primitive> primitives,
             const impostor::Cutout* cutout) {
  assert(!primitives.empty());
  const bake::Layer layer = primitives.front().layer;
  const bool is_one_layer = std::ranges::all_of(primitives, [&](const Primitive& p) { return p.layer == layer; });
  tinygltf::Mesh mesh;
  mesh.name = name;
  if (is_one_layer) mesh.extras = layer_extras(layer);
  for (const Primitive& p : primitives) {
    mesh.primitives.push_back(primitive_of(f, p, cutout));
    if (!is_one_layer) mesh.primitives.back().extras = layer_extras(p.layer);
  }
  f.model.meshes.push_back(std::move(mesh));
  return static_cast<int>(f.model.meshes.size()) - 1;
}

tinygltf::Value feature_ids(GlbBuilder& f, const char* extension) {
  f.extensions.insert(extension);
  const Value::Object ids = {{"featureCount", Value(static_cast<int>(f.tile.features.size()))},
                             {"attribute", Value(0)},
                             {"propertyTable", Value(0)}};
  return Value(Value::Object{{"featureIds", Value(Value::Array{Value(ids)})}});
}

}  // namespace citykiln::exporters
