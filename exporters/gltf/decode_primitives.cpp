#include "exporters/gltf/decode_primitives.h"

#include <algorithm>
#include <cmath>

#include "exporters/gltf/flat_shading.h"
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

int attribute(const std::map<std::string, int>& attributes, const char* name) {
  const auto found = attributes.find(name);
  expect(found != attributes.end(), "the attributes that citykiln writes");
  return found->second;
}

bool has_picture(const tinygltf::Model& model, ColourSource colour_source) {
  const char* name = colour_source == ColourSource::kByMarkingAtlas ? "marking_atlas"
                     : colour_source == ColourSource::kByCutout     ? "cutout"
                                                                    : "facade_atlas";
  return colour_source == ColourSource::kByMaterial ||
         std::ranges::count(model.images, name, &tinygltf::Image::name) > 0;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(GltfReader& reader, int accessor, std::size_t vertices) {
  const bool narrow = item(reader.model.accessors, accessor, "an accessor that exists").componentType ==
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  std::vector<std::uint32_t> indices;
  if (narrow) {
    const auto values =
        values_of<std::uint16_t>(reader, accessor, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR);
    indices.assign(values.begin(), values.end());
  } else {
    indices = values_of<std::uint32_t>(reader, accessor, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
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

std::vector<materials::Tint> colours_of(GltfReader& reader, int accessor, const materials::Tint& largest) {
  auto colours =
      values_of<materials::Tint>(reader, accessor, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC4);
  for (materials::Tint& colour : colours) colour = tint_of(colour, largest);
  return colours;
}

Primitive read_primitive(GltfReader& reader, const tinygltf::Primitive& p, std::size_t features) {
  Primitive out;
  const tinygltf::Material& material = item(reader.model.materials, p.material, "a material that exists");
  const bake::PrimitiveKey key = primitive_key_named(material.name);
  out.material = key.material, out.colour_source = key.colour_source;
  out.positions = turned(values_of<Float3>(reader, attribute(p.attributes, "POSITION"), TINYGLTF_COMPONENT_TYPE_FLOAT,
                                           TINYGLTF_TYPE_VEC3));
  const bool has_normals = p.attributes.count("NORMAL") != 0;
  if (has_normals)
    out.normals = turned(values_of<Float3>(reader, attribute(p.attributes, "NORMAL"), TINYGLTF_COMPONENT_TYPE_FLOAT,
                                           TINYGLTF_TYPE_VEC3));
  out.colours = colours_of(reader, attribute(p.attributes, "COLOR_0"), tint_in(material.extras));
  if (p.attributes.count("TEXCOORD_0") != 0)
    out.uvs = finite(values_of<Float2>(reader, attribute(p.attributes, "TEXCOORD_0"), TINYGLTF_COMPONENT_TYPE_FLOAT,
                                       TINYGLTF_TYPE_VEC2));
  if (p.attributes.count("_FEATURE_ID_0") != 0)
    out.features = as_numbers(values_of<float>(reader, attribute(p.attributes, "_FEATURE_ID_0"),
                                               TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR),
                              features);
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
    if (primitive.colour_source == ColourSource::kByCutout) primitive = without_backs(primitive);
    // large primitives are written in parts, which follow each other
    if (!primitives.empty() && key_of(primitives.back()) == key_of(primitive))
      append_primitive(primitives.back(), primitive);
    else
      primitives.push_back(std::move(primitive));
  }
  return primitives;
}

}  // namespace citykiln::exporters
