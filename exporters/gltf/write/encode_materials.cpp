#include "exporters/gltf/write/encode_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/image_units.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/plant_tints.h"
#include "exporters/gltf/write/encode_pictures.h"

namespace citykiln::exporters {
namespace {

using bake::Primitive;
using materials::ColourSource;
using Json = nlohmann::json;
using Colour = std::array<double, 4>;

constexpr Colour kWhite = {1, 1, 1, 1};

// The image that a primitive's uvs lie on; null where they show none.
const materials::TextureImage* image_of_material(const GlbBuilder& f, const MaterialKey& key) {
  if (key.primitive.colour_source == ColourSource::kByMarkingAtlas) return &f.tile.marking_atlas;
  if (key.primitive.colour_source == ColourSource::kByAtlas) return &f.tile.facade_atlas.colour;
  if (key.cutout != nullptr) return &key.cutout->colour;
  return key.texture == nullptr ? nullptr : &shown_image(*key.texture);
}

// A reference to an image.
Json shown(GlbBuilder& f, const materials::TextureImage& picture) {
  Json info = {{"index", picture_number(f, &picture)}};
  if (!f.has_uvs_in_metres()) return info;
  f.extensions.insert(kTextureTransformExtension);
  info["extensions"][kTextureTransformExtension]["scale"] = {1 / (picture.columns * picture.texel_m),
                                                             1 / (picture.rows * picture.texel_m)};
  return info;
}

// The factor of the base colour, times the tint of a plant. With an atlas or cutout it is white, since the image holds
// the reflectance.
Colour base_colour_factor(const MaterialKey& key) {
  Colour colour = kWhite;
  const auto set = [&](const auto& rgb) { std::ranges::copy(rgb, colour.begin()); };
  if (key.primitive.colour_source == ColourSource::kByMaterial) {
    set(values_of(key.primitive.material).base_colour);
    if (key.texture != nullptr && !key.texture->colour.texels.empty()) set(colour_factor(*key.texture));
  }
  for (std::size_t c = 0; c < 3; ++c) colour[c] *= key.tint[c] / 255.0;
  return colour;
}

// The image of the base colour; null where the material has none.
const materials::TextureImage* colour_image(const GlbBuilder& f, const MaterialKey& key) {
  if (key.texture != nullptr && key.texture->colour.texels.empty()) return nullptr;
  return image_of_material(f, key);
}

// Sets the base colour, roughness and metalness. With the facade atlas roughness and metalness stay 1.
void set_surface(GlbBuilder& f, const MaterialKey& key, Json& m) {
  Json pbr;
  if (const Colour colour = base_colour_factor(key); colour != kWhite) pbr["baseColorFactor"] = colour;
  if (const materials::TextureImage* image = colour_image(f, key)) pbr["baseColorTexture"] = shown(f, *image);
  const auto& values = values_of(key.primitive.material);
  if (key.primitive.colour_source == ColourSource::kByAtlas) {
    pbr["metallicRoughnessTexture"] = shown(f, f.tile.facade_atlas.surface);
  } else {
    if (values.roughness != 1) pbr["roughnessFactor"] = values.roughness;
    if (values.metallic != 1) pbr["metallicFactor"] = values.metallic;
  }
  if (!pbr.empty()) m["pbrMetallicRoughness"] = std::move(pbr);
}

// Sets emission, of which 1 is kEmission_cd_m2.
void set_emission(GlbBuilder& f, const MaterialKey& key, Json& m) {
  if (key.primitive.colour_source == ColourSource::kByAtlas && !f.tile.facade_atlas.emission.texels.empty()) {
    m["emissiveTexture"] = shown(f, f.tile.facade_atlas.emission);
    m["emissiveFactor"] = {1.0, 1.0, 1.0};
  }
  if (key.primitive.colour_source == ColourSource::kByMaterial && emits(key.primitive.material))
    m["emissiveFactor"] = emission_of(key.primitive.material);
}

// Some programs keep materials by name, across tiles and levels: those with images of this file have a name of their
// own, and those with a tint are named after it.
std::string material_name_in_file(GlbBuilder& f, const MaterialKey& key) {
  std::string name = material_name(key.primitive, f.tile.textures);
  if (key.primitive.colour_source != ColourSource::kByMaterial)
    name += fmt::format("_{}_{}m", to_string(f.tile.tile), f.tile.tolerance_m);
  else if (key.tint != materials::kNoTint)
    name += fmt::format("_{:02x}{:02x}{:02x}", key.tint[0], key.tint[1], key.tint[2]);
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::any_of(f.file.gltf["materials"], [&](const Json& m) { return m["name"] == wanted; });
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

std::size_t material_number(GlbBuilder& f, const MaterialKey& key) {
  const auto same = std::ranges::find(f.material_keys, key);
  if (same != f.material_keys.end()) return static_cast<std::size_t>(same - f.material_keys.begin());
  Json m = {{"name", material_name_in_file(f, key)}};
  set_surface(f, key, m);
  // from which it is read back
  if (key.tint != materials::kNoTint) m["extras"]["tint"] = {key.tint[0], key.tint[1], key.tint[2]};
  if (const materials::TextureImage* normals = normals_of(f, key)) m["normalTexture"] = shown(f, *normals);
  // leaves are flat; texels with an opacity below a half are holes
  if (key.cutout != nullptr) m["alphaMode"] = "MASK";
  if (key.cutout != nullptr && !key.has_backs) m["doubleSided"] = true;
  set_emission(f, key, m);
  f.material_keys.push_back(key);
  return f.add("materials", std::move(m));
}

std::size_t add_uvs(GlbBuilder& f, const Primitive& p, const MaterialKey& key) {
  const materials::TextureImage* image = f.has_uvs_in_metres() ? nullptr : image_of_material(f, key);
  if (image == nullptr) return f.add_attribute(p.uvs, ViewUse::kVertices);
  return f.add_attribute(p.uvs, ViewUse::kVertices, [&](const bake::Float2& uv) { return in_image_units(*image, uv); });
}

}  // namespace citykiln::exporters
