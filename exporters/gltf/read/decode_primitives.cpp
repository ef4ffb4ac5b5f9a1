#include "exporters/gltf/read/decode_primitives.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exporters/gltf/flat_shading.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/plant_tints.h"
#include "exporters/gltf/split_buildings.h"

namespace citykiln::exporters {
namespace {

using bake::Float2;
using bake::Float3;
using bake::Primitive;
using materials::ColourSource;

bool has_attribute(const tinygltf::Primitive& p, const char* name) { return p.attributes.count(name) != 0; }

// The values of an attribute; none where the primitive lacks it.
template <typename T>
std::vector<T> attribute_values(GltfReader& reader, const tinygltf::Primitive& p, const char* name) {
  return has_attribute(p, name) ? values_of<T>(reader, p.attributes.at(name)) : std::vector<T>();
}

bool has_picture(const tinygltf::Model& model, ColourSource colour_source) {
  const char* name = colour_source == ColourSource::kByMarkingAtlas ? kMarkingAtlasImage
                     : colour_source == ColourSource::kByCutout     ? kCutoutImage
                                                                    : kFacadeAtlasImage;
  return colour_source == ColourSource::kByMaterial ||
         std::ranges::count(model.images, name, &tinygltf::Image::name) > 0;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(GltfReader& reader, int accessor, std::size_t vertices) {
  const bool narrow = item(reader.model.accessors, accessor, "an accessor that exists").componentType ==
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  std::vector<std::uint32_t> indices;
  if (narrow) {
    const auto values = values_of<std::uint16_t>(reader, accessor);
    indices.assign(values.begin(), values.end());
  } else {
    indices = values_of<std::uint32_t>(reader, accessor);
  }
  expect(indices.size() % 3 == 0, "three indices a triangle");
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) expect(indices[i + k] < vertices, "indices of vertices that exist");
    triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  }
  return triangles;
}

// The layer in the extras of a primitive, or else of its mesh.
bake::Layer layer_in(const tinygltf::Value& primitive, const tinygltf::Value& mesh) {
  const tinygltf::Value& name = member(primitive.IsObject() && primitive.Has("layer") ? primitive : mesh, "layer");
  expect(name.IsString(), "the name of a layer");
  const auto layer = bake::layer_named(name.Get<std::string>());
  expect(layer.has_value(), "the name of a layer");
  return *layer;
}

// The tint in the extras of a material, if it has one.
materials::Tint tint_in(const tinygltf::Value& extras) {
  materials::Tint tint = materials::kNoTint;
  if (!extras.IsObject() || !extras.Has("tint")) return tint;
  for (std::size_t c = 0; c < 3; ++c) {
    const double channel = element(member(extras, "tint"), c);
    expect(channel >= 0 && channel <= 255 && channel == std::floor(channel), "a tint of three bytes");
    tint[c] = static_cast<std::uint8_t>(channel);
  }
  return tint;
}

Primitive read_primitive(GltfReader& reader, const tinygltf::Primitive& p, std::size_t features) {
  expect(has_attribute(p, "POSITION"), "the attributes that citykiln writes");
  Primitive out;
  const tinygltf::Material& material = item(reader.model.materials, p.material, "a material that exists");
  const bake::PrimitiveKey key = primitive_key_named(material.name);
  const materials::Tint largest = tint_in(material.extras);
  const bool has_normals = has_attribute(p, "NORMAL");
  out.material = key.material, out.colour_source = key.colour_source;
  out.positions = turned(attribute_values<Float3>(reader, p, "POSITION"));
  out.normals = turned(attribute_values<Float3>(reader, p, "NORMAL"));
  out.colours = attribute_values<materials::Tint>(reader, p, "COLOR_0");
  for (materials::Tint& colour : out.colours) colour = tint_of(colour, largest);
  if (!has_attribute(p, "COLOR_0")) out.colours.assign(out.positions.size(), largest);
  out.uvs = finite(attribute_values<Float2>(reader, p, "TEXCOORD_0"));
  out.features = as_numbers(attribute_values<float>(reader, p, "_FEATURE_ID_0"), features);
  const std::size_t n = out.positions.size();
  expect((!has_normals || out.normals.size() == n) && out.colours.size() == n &&
             (out.features.empty() || out.features.size() == n) && (out.uvs.empty() || out.uvs.size() == n),
         "as many values in each attribute");
  expect(out.colour_source == ColourSource::kByMaterial ||
             (!out.uvs.empty() && has_picture(reader.model, out.colour_source)),
         "an image, and uvs, for primitives that an image colours");
  out.triangles = triangles_of(reader, p.indices, n);
  return has_normals ? out : with_face_normals(out);
}

}  // namespace

std::vector<Primitive> primitives_of(GltfReader& reader, int mesh_number, std::size_t features) {
  const tinygltf::Mesh& mesh = item(reader.model.meshes, mesh_number, "a mesh that exists");
  expect(!mesh.primitives.empty(), "a primitive in each mesh");
  std::vector<Primitive> primitives;
  for (const tinygltf::Primitive& p : mesh.primitives) {
    Primitive primitive = read_primitive(reader, p, features);
    primitive.layer = layer_in(p.extras, mesh.extras);
    const bool is_double = item(reader.model.materials, p.material, "a material that exists").doubleSided;
    if (primitive.colour_source == ColourSource::kByCutout && !is_double)
      primitive = without_backs(std::move(primitive));
    // large primitives are written in parts, which follow each other
    if (!primitives.empty() && key_of(primitives.back()) == key_of(primitive))
      append_primitive(primitives.back(), primitive);
    else
      primitives.push_back(std::move(primitive));
  }
  return primitives;
}

}  // namespace citykiln::exporters
