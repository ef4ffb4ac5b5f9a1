#include "exporters/gltf/write/encode_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "exporters/gltf/flat_shading.h"
#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/image_units.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/object_runs.h"
#include "exporters/gltf/plant_tints.h"
#include "exporters/gltf/write/encode_pictures.h"
#include "exporters/gltf/write/tangents.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;
using Json = nlohmann::json;

// Writes the materials of a .glb.

using materials::ColourSource;
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

// Sets the base colour, roughness and metalness. With an image of them, roughness and metalness stay 1.
void set_surface(GlbBuilder& f, const MaterialKey& key, Json& m) {
  Json pbr;
  if (const Colour colour = base_colour_factor(key); colour != kWhite) pbr["baseColorFactor"] = colour;
  if (const materials::TextureImage* image = colour_image(f, key)) pbr["baseColorTexture"] = shown(f, *image);
  const auto& values = values_of(key.primitive.material);
  if (key.primitive.colour_source == ColourSource::kByAtlas) {
    pbr["metallicRoughnessTexture"] = shown(f, f.tile.facade_atlas.surface);
  } else if (key.texture != nullptr && !key.texture->surface.texels.empty()) {
    pbr["metallicRoughnessTexture"] = shown(f, key.texture->surface);
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

// True if the primitive is written with faces for both sides.
bool writes_backs(const GlbBuilder& f, const Primitive& p) {
  return values_of(f.options.target).culls_backs && has_backs(p);
}

// Returns the key of a primitive's material.
// @param cutout  The result of cutout_like() for an instanced mesh; else null.
MaterialKey material_key_of(const GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  MaterialKey key{.primitive = {{}, p.material, !p.uvs.empty(), p.colour_source}, .tint = largest_tint(p)};
  if (p.colour_source == ColourSource::kByCutout) key.cutout = cutout, key.has_backs = writes_backs(f, p);
  if (p.colour_source != ColourSource::kByMaterial) return key;
  const auto found = std::ranges::find(f.tile.textures, p.material, &materials::Texture::material);
  key.primitive.has_uvs = key.primitive.has_uvs && found != f.tile.textures.end();
  if (key.primitive.has_uvs) key.texture = &**found;
  return key;
}

// Returns the normal map of a material; null if it has none.
const materials::TextureImage* normals_of(const GlbBuilder& f, const MaterialKey& key) {
  const materials::TextureImage* normals = nullptr;
  if (key.primitive.colour_source == ColourSource::kByAtlas) normals = &f.tile.facade_atlas.normal;
  if (key.texture != nullptr) normals = &key.texture->normal;
  if (key.cutout != nullptr) normals = &key.cutout->normal;
  return normals == nullptr || normals->texels.empty() ? nullptr : normals;
}

// Returns the index of the material with this key. Adds it at the first call.
std::size_t material_number(GlbBuilder& f, const MaterialKey& key) {
  const auto same = std::ranges::find(f.material_keys, key);
  if (same != f.material_keys.end()) return static_cast<std::size_t>(same - f.material_keys.begin());
  Json m = {{"name", material_name_in_file(f, key)}};
  set_surface(f, key, m);
  // from which it is read back
  if (key.tint != materials::kNoTint) m["extras"]["tint"] = {key.tint[0], key.tint[1], key.tint[2]};
  if (const materials::TextureImage* normals = normals_of(f, key)) m["normalTexture"] = shown(f, *normals);
  // leaves and railings are flat; texels with an opacity below a half are holes
  const bool has_holes = key.cutout != nullptr || (key.texture != nullptr && !key.texture->opacity.empty());
  if (has_holes) m["alphaMode"] = "MASK";
  if (has_holes && !key.has_backs) m["doubleSided"] = true;
  set_emission(f, key, m);
  f.material_keys.push_back(key);
  return f.add("materials", std::move(m));
}

// Adds TEXCOORD_0 and returns its accessor. Its unit is the image's size, or metres in packed meshes.
std::size_t add_uvs(GlbBuilder& f, const Primitive& p, const MaterialKey& key) {
  const materials::TextureImage* image = f.has_uvs_in_metres() ? nullptr : image_of_material(f, key);
  if (image == nullptr) return f.add_attribute(p.uvs, ViewUse::kVertices);
  return f.add_attribute(p.uvs, ViewUse::kVertices, [&](const bake::Float2& uv) { return in_image_units(*image, uv); });
}

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

// False if the material's tint is that of all vertices.
bool has_shares(const Primitive& p, const materials::Tint& largest) {
  return std::ranges::any_of(p.colours, [&](const materials::Tint& tint) { return tint != largest; });
}

Json encoded_primitive(GlbBuilder& f, const Primitive& front, const impostor::Cutout* cutout) {
  const MaterialKey key = material_key_of(f, front, cutout);
  Json out = {{"mode", kTrianglesMode}, {"material", material_number(f, key)}};
  const std::optional<Primitive> both = key.has_backs ? std::optional(with_backs(front)) : std::nullopt;
  const Primitive& p = both ? *both : front;
  Json& attributes = out["attributes"];
  attributes["POSITION"] = add_positions(f, p.positions);
  if (!p.normals.empty()) attributes["NORMAL"] = f.add_turned(p.normals, ViewUse::kVertices);
  if (has_shares(p, key.tint)) attributes["COLOR_0"] = add_colours(f, p, key.tint);
  if (!p.uvs.empty()) attributes["TEXCOORD_0"] = add_uvs(f, p, key);
  if (normals_of(f, key) != nullptr) attributes["TANGENT"] = f.add_turned(tangents_of(front), ViewUse::kVertices);
  if (!p.features.empty()) {
    attributes["_FEATURE_ID_0"] = f.add_as_floats(p.features, ViewUse::kVertices);
    out["extensions"]["EXT_mesh_features"] = feature_ids(f, "EXT_mesh_features");
  }
  out["indices"] = add_indices(f, p);
  return out;
}

// True if the target's reader may shade the primitive's faces. Codecs round positions again, so that faces lean. Leaves
// keep their normals: a few flat ones would be a material and a call of their own.
bool may_lack_normals(const GlbBuilder& f, const Primitive& p, const impostor::Cutout* cutout) {
  if (!values_of(f.options.target).shades_flat || f.options.compression > Compression::kQuantize) return false;
  return p.colour_source != ColourSource::kByCutout && normals_of(f, material_key_of(f, p, cutout)) == nullptr;
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
    if (!may_lack_normals(f, p, cutout)) {
      for_each_part(p, add);
      continue;
    }
    ByShading parts = by_shading(p);
    if (!parts.flat.triangles.empty()) for_each_part(without_normals(std::move(parts.flat)), add);
    if (!parts.smooth.triangles.empty()) for_each_part(parts.smooth, add);
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
