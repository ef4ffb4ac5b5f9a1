#include "exporters/gltf/encode_materials.h"

#include <algorithm>
#include <cmath>

#include "exporters/gltf/encode_pictures.h"
#include "exporters/gltf/material_names.h"

namespace citykiln::exporters {
namespace {

using bake::Primitive;
using materials::ColourSource;
using tinygltf::Value;

// A reference to an image by uvs in metres.
template <typename Info>
Info shown(GlbBuilder& f, const materials::TextureImage& picture) {
  const Value::Array scale = {Value(1 / (picture.columns * picture.texel_m)),
                              Value(1 / (picture.rows * picture.texel_m))};
  f.extensions.insert("KHR_texture_transform");
  Info info;
  info.index = picture_number(f, &picture);
  info.extensions["KHR_texture_transform"] = Value(Value::Object{{"scale", Value(scale)}});
  return info;
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

}  // namespace

MaterialKey material_key_of(const GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  if (p.colour_source == ColourSource::kByCutout) return {key_of(p), nullptr, cutout};
  if (p.colour_source != ColourSource::kByMaterial) return {key_of(p)};
  const auto found = std::ranges::find(f.tile.textures, p.material, &materials::Texture::material);
  if (p.uvs.empty() || found == f.tile.textures.end()) return {{p.material, false, ColourSource::kByMaterial}};
  return {key_of(p), &*found};
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
  m.name = material_name(key.primitive, f.tile.textures);
  set_colour(f, key, m.pbrMetallicRoughness);
  if (const materials::TextureImage* normals = normals_of(f, key))
    m.normalTexture = shown<tinygltf::NormalTextureInfo>(f, *normals);
  // leaves are flat; texels with an opacity below a half are holes
  if (key.cutout != nullptr) m.alphaMode = "MASK", m.doubleSided = true;
  set_surface(f, key, m.pbrMetallicRoughness);
  set_emission(f, key, m);
  f.model.materials.push_back(m), f.material_keys.push_back(key);
  return static_cast<int>(f.material_keys.size()) - 1;
}

}  // namespace citykiln::exporters
