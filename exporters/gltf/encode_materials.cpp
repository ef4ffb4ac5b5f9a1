#include "exporters/gltf/encode_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exporters/gltf/encode_pictures.h"
#include "exporters/gltf/image_units.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/plant_tints.h"

namespace citykiln::exporters {
namespace {

using bake::Primitive;
using materials::ColourSource;
using tinygltf::Value;

// The image that a primitive's uvs lie on; null where they show none.
const materials::TextureImage* image_of_material(const GlbBuilder& f, const MaterialKey& key) {
  if (key.primitive.colour_source == ColourSource::kByMarkingAtlas) return &f.tile.marking_atlas;
  if (key.primitive.colour_source == ColourSource::kByAtlas) return &f.tile.facade_atlas.colour;
  if (key.cutout != nullptr) return &key.cutout->colour;
  return key.texture == nullptr ? nullptr : &shown_image(*key.texture);
}

// A reference to an image.
template <typename Info>
Info shown(GlbBuilder& f, const materials::TextureImage& picture) {
  if (!f.has_uvs_in_metres()) {
    Info info;
    info.index = picture_number(f, &picture);
    return info;
  }
  const Value::Array scale = {Value(1 / (picture.columns * picture.texel_m)),
                              Value(1 / (picture.rows * picture.texel_m))};
  f.extensions.insert("KHR_texture_transform");
  Info info;
  info.index = picture_number(f, &picture);
  info.extensions["KHR_texture_transform"] = Value(Value::Object{{"scale", Value(scale)}});
  return info;
}

// Multiplies the base colour by a plant's tint, and says it in the extras, from which it is read back.
void add_tint(const materials::Tint& tint, tinygltf::Material& m) {
  if (tint == materials::kNoTint) return;
  for (std::size_t c = 0; c < 3; ++c) m.pbrMetallicRoughness.baseColorFactor[c] *= tint[c] / 255.0;
  m.extras = Value(Value::Object{{"tint", Value(Value::Array{Value(tint[0]), Value(tint[1]), Value(tint[2])})}});
}

// Sets the base colour. With an atlas or cutout the factor stays white, since the image holds the reflectance.
void set_colour(GlbBuilder& f, const MaterialKey& key, tinygltf::PbrMetallicRoughness& m) {
  const auto& base = values_of(key.primitive.material).base_colour;
  if (key.primitive.colour_source == ColourSource::kByMarkingAtlas)
    m.baseColorTexture = shown<tinygltf::TextureInfo>(f, f.tile.marking_atlas);
  if (key.primitive.colour_source == ColourSource::kByAtlas)
    m.baseColorTexture = shown<tinygltf::TextureInfo>(f, f.tile.facade_atlas.colour);
  if (key.cutout != nullptr) m.baseColorTexture = shown<tinygltf::TextureInfo>(f, key.cutout->colour);
  if (key.primitive.colour_source != ColourSource::kByMaterial) return;
  m.baseColorFactor = {base[0], base[1], base[2], 1};
  if (key.texture == nullptr || key.texture->colour.texels.empty()) return;
  const auto factor = colour_factor(*key.texture);
  m.baseColorFactor = {factor[0], factor[1], factor[2], 1};
  m.baseColorTexture = shown<tinygltf::TextureInfo>(f, key.texture->colour);
}

// Sets roughness and metalness. With the facade atlas the factors stay 1.
void set_surface(GlbBuilder& f, const MaterialKey& key, tinygltf::PbrMetallicRoughness& m) {
  if (key.primitive.colour_source == ColourSource::kByAtlas) {
    m.metallicRoughnessTexture = shown<tinygltf::TextureInfo>(f, f.tile.facade_atlas.surface);
    return;
  }
  const auto& values = values_of(key.primitive.material);
  m.roughnessFactor = values.roughness, m.metallicFactor = values.metallic;
}

// Sets emission, of which 1 is kEmission_cd_m2.
void set_emission(GlbBuilder& f, const MaterialKey& key, tinygltf::Material& m) {
  if (key.primitive.colour_source == ColourSource::kByAtlas && !f.tile.facade_atlas.emission.texels.empty()) {
    m.emissiveTexture = shown<tinygltf::TextureInfo>(f, f.tile.facade_atlas.emission);
    m.emissiveFactor = {1, 1, 1};
  }
  const auto own = emission_of(key.primitive.material);
  if (key.primitive.colour_source == ColourSource::kByMaterial && emits(key.primitive.material))
    m.emissiveFactor = {own[0], own[1], own[2]};
}

// Some programs keep materials by name, across tiles and levels: those with images of this file have a name of their
// own, and those with a tint are named after it.
std::string material_name_in_file(const GlbBuilder& f, const MaterialKey& key) {
  std::string name = material_name(key.primitive, f.tile.textures);
  if (key.primitive.colour_source != ColourSource::kByMaterial)
    name += fmt::format("_{}_{}m", to_string(f.tile.tile), f.tile.tolerance_m);
  else if (key.tint != materials::kNoTint)
    name += fmt::format("_{:02x}{:02x}{:02x}", key.tint[0], key.tint[1], key.tint[2]);
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::count(f.model.materials, wanted, &tinygltf::Material::name) > 0;
  };
  if (!is_taken(name)) return name;
  int number = 2;
  while (is_taken(fmt::format("{}_{}", name, number))) ++number;
  return fmt::format("{}_{}", name, number);
}

}  // namespace

MaterialKey material_key_of(const GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  MaterialKey key{.primitive = {{}, p.material, !p.uvs.empty(), p.colour_source}, .tint = largest_tint(p)};
  if (p.colour_source == ColourSource::kByCutout) key.cutout = cutout, key.has_backs = has_backs(p);
  if (p.colour_source != ColourSource::kByMaterial) return key;
  const auto found = std::ranges::find(f.tile.textures, p.material, &materials::Texture::material);
  key.primitive.has_uvs = key.primitive.has_uvs && found != f.tile.textures.end();
  if (key.primitive.has_uvs) key.texture = &*found;
  return key;
}

const materials::TextureImage* normals_of(const GlbBuilder& f, const MaterialKey& key) {
  const materials::TextureImage* normals = nullptr;
  if (key.primitive.colour_source == ColourSource::kByAtlas) normals = &f.tile.facade_atlas.normal;
  if (key.texture != nullptr) normals = &key.texture->normal;
  if (key.cutout != nullptr) normals = &key.cutout->normal;
  return normals == nullptr || normals->texels.empty() ? nullptr : normals;
}

int material_number(GlbBuilder& f, const MaterialKey& key) {
  const auto same = std::ranges::find(f.material_keys, key);
  if (same != f.material_keys.end()) return static_cast<int>(same - f.material_keys.begin());
  tinygltf::Material m;
  m.name = material_name_in_file(f, key);
  set_colour(f, key, m.pbrMetallicRoughness);
  add_tint(key.tint, m);
  if (const materials::TextureImage* normals = normals_of(f, key))
    m.normalTexture = shown<tinygltf::NormalTextureInfo>(f, *normals);
  // leaves are flat; texels with an opacity below a half are holes
  if (key.cutout != nullptr) m.alphaMode = "MASK", m.doubleSided = !key.has_backs;
  set_surface(f, key, m.pbrMetallicRoughness);
  set_emission(f, key, m);
  f.model.materials.push_back(m), f.material_keys.push_back(key);
  return static_cast<int>(f.material_keys.size()) - 1;
}

int add_uvs(GlbBuilder& f, const Primitive& p, const MaterialKey& key) {
  const materials::TextureImage* image = f.has_uvs_in_metres() ? nullptr : image_of_material(f, key);
  if (image != nullptr) {
    const int view = f.add_view_of(p.uvs, TINYGLTF_TARGET_ARRAY_BUFFER,
                                   [&](const bake::Float2& uv) { return in_image_units(*image, uv); });
    return f.add_accessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, p.uvs.size());
  }
  return f.add_attribute(p.uvs, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2);
}

}  // namespace citykiln::exporters
