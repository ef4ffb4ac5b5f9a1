#include "exporters/usd/usd_materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/content_hash.h"
#include "exporters/gltf/leaf_backs.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/pictures/picture_formats.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Float4;
using bake::Primitive;
using materials::ColourSource;
using materials::TextureImage;

std::string scope_path() { return std::string(kUsdTilePath) + "/materials"; }

const materials::Texture* texture_of(const UsdBuilder& b, const Primitive& p) {
  if (p.colour_source != ColourSource::kByMaterial || p.uvs.empty()) return nullptr;
  const auto found = std::ranges::find(b.tile.textures, p.material, &materials::Texture::material);
  return found == b.tile.textures.end() ? nullptr : &**found;
}

// Integer arithmetic, rounded to the nearest.
materials::Tint mean_tint(const Primitive& p) {
  std::array<std::uint64_t, 3> sums{};
  for (const materials::Tint& tint : p.colours)
    for (std::size_t c = 0; c < 3; ++c) sums[c] += tint[c];
  const std::uint64_t count = std::max<std::uint64_t>(1, p.colours.size());
  const auto mean = [&](std::size_t c) { return static_cast<std::uint8_t>((sums[c] + count / 2) / count); };
  return {mean(0), mean(1), mean(2), 255};
}

UsdMaterialKey key_of_material(const UsdBuilder& b, const Primitive& p, const impostor::Cutout* cutout) {
  UsdMaterialKey key{.primitive = {{}, p.material, true, p.colour_source}, .texture = texture_of(b, p)};
  if (p.colour_source == ColourSource::kByCutout) key.cutout = cutout, key.has_backs = has_backs(p);
  key.primitive.has_uvs = image_of(b, p, cutout) != nullptr;
  if (key.primitive.has_uvs) key.tint = mean_tint(p);
  return key;
}

std::string material_prim_name(const UsdBuilder& b, const UsdMaterialKey& key) {
  const std::string name = material_name(key.primitive, b.tile.textures);
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::count(b.materials, wanted, &UsdMaterial::name) > 0;
  };
  if (!is_taken(name)) return name;
  int number = 2;
  while (is_taken(fmt::format("{}_{}", name, number))) ++number;
  return fmt::format("{}_{}", name, number);
}

// ---- textures ----

// Adds an image as a file, unless it is one already, and returns its path from the layer.
std::string add_texture_file(UsdBuilder& b, std::string_view name, const TextureImage& image, PictureContent content,
                             std::span<const std::uint8_t> opacity = {}) {
  EncodedPicture picture = encode_picture(image, opacity, content, PictureFormats::kPngAndJpeg);
  const std::string file = fmt::format("{}_{}.{}", name, hash_text(content_hash(picture.bytes)),
                                       picture.mime_type == "image/jpeg" ? "jpg" : "png");
  if (std::ranges::find(b.textures, file, &UsdFile::name) == b.textures.end())
    b.textures.push_back({file, std::move(picture.bytes)});
  return b.texture_folder + file;
}

// The way a shader reads an image.
struct ImageUse {
  std::string_view name;  ///< The shader's name.
  std::string path;       ///< The file's path.
  bool is_colour = false;
  std::string_view wrap_s = "clamp", wrap_t = "clamp";
  Float4 scale{1, 1, 1, 1}, bias{0, 0, 0, 0};
  bool has_alpha = false;
};

void write_image(UsdBuilder& b, const std::string& material, const ImageUse& use) {
  b.writer.begin_prim({.type = "Shader", .name = std::string(use.name)});
  b.writer.write({.type = "token", .name = "info:id", .value = UsdToken{"UsdUVTexture"}, .is_uniform = true});
  b.writer.write({.type = "asset", .name = "inputs:file", .value = UsdAsset{use.path}});
  b.writer.write({.type = "float2", .name = "inputs:st", .connection = material + "/st.outputs:result"});
  b.writer.write({.type = "token", .name = "inputs:wrapS", .value = UsdToken{std::string(use.wrap_s)}});
  b.writer.write({.type = "token", .name = "inputs:wrapT", .value = UsdToken{std::string(use.wrap_t)}});
  b.writer.write(
      {.type = "token", .name = "inputs:sourceColorSpace", .value = UsdToken{use.is_colour ? "sRGB" : "raw"}});
  if (use.scale != Float4{1, 1, 1, 1}) b.writer.write({.type = "float4", .name = "inputs:scale", .value = use.scale});
  if (use.bias != Float4{0, 0, 0, 0}) b.writer.write({.type = "float4", .name = "inputs:bias", .value = use.bias});
  b.writer.write({.type = "float3", .name = "outputs:rgb"});
  if (!use.is_colour)
    for (const char* channel : {"outputs:g", "outputs:b"}) b.writer.write({.type = "float", .name = channel});
  if (use.has_alpha) b.writer.write({.type = "float", .name = "outputs:a"});
  b.writer.end_prim();
}

void write_reader(UsdBuilder& b, const char* name, const char* type, const char* value_type, const char* primvar) {
  b.writer.begin_prim({.type = "Shader", .name = name});
  b.writer.write({.type = "token", .name = "info:id", .value = UsdToken{type}, .is_uniform = true});
  b.writer.write({.type = "string", .name = "inputs:varname", .value = std::string(primvar)});
  b.writer.write({.type = value_type, .name = "outputs:result"});
  b.writer.end_prim();
}

using ImageUses = std::vector<ImageUse>;

Float4 tint_scale(const materials::Tint& tint) {
  const auto channel = [&](std::size_t c) { return static_cast<float>(tint[c]) / 255; };
  return {channel(0), channel(1), channel(2), 1};
}

// Texels of 0 … 1 stand for components of -1 … 1.
void add_normal_map(UsdBuilder& b, std::string_view name, const TextureImage& image, std::string_view wrap,
                    ImageUses& uses) {
  if (image.texels.empty()) return;
  uses.push_back({.name = "normals",
                  .path = add_texture_file(b, name, image, PictureContent::kExact),
                  .wrap_s = wrap,
                  .wrap_t = wrap,
                  .scale = {2, 2, 2, 1},
                  .bias = {-1, -1, -1, 0}});
}

void add_marking_atlas(UsdBuilder& b, const Float4& tint, ImageUses& uses) {
  uses.push_back({.name = "colour",
                  .path = add_texture_file(b, "marking_atlas", b.tile.marking_atlas, PictureContent::kExact),
                  .is_colour = true,
                  .wrap_t = "repeat",
                  .scale = tint});
}

void add_facade_atlas(UsdBuilder& b, const Float4& tint, ImageUses& uses) {
  const impostor::Atlas& atlas = b.tile.facade_atlas;
  uses.push_back({.name = "colour",
                  .path = add_texture_file(b, "facade_atlas", atlas.colour, PictureContent::kAtlas),
                  .is_colour = true,
                  .scale = tint});
  uses.push_back(
      {.name = "surfaces", .path = add_texture_file(b, "facade_atlas_surface", atlas.surface, PictureContent::kExact)});
  if (!atlas.emission.texels.empty())
    uses.push_back({.name = "emission",
                    .path = add_texture_file(b, "facade_atlas_emission", atlas.emission, PictureContent::kAtlas),
                    .is_colour = true});
  add_normal_map(b, "facade_atlas_normal", atlas.normal, "clamp", uses);
}

void add_cutout(UsdBuilder& b, const impostor::Cutout& cutout, const Float4& tint, ImageUses& uses) {
  uses.push_back({.name = "colour",
                  .path = add_texture_file(b, "cutout", cutout.colour, PictureContent::kExact, cutout.opacity),
                  .is_colour = true,
                  .scale = tint,
                  .has_alpha = true});
  add_normal_map(b, "cutout_normal", cutout.normal, "clamp", uses);
}

void add_repeated(UsdBuilder& b, const materials::Texture& texture, Float4 tint, ImageUses& uses) {
  const std::string name(values_of(texture.material).name);
  const auto factor = materials::colour_factor(texture);
  for (std::size_t c = 0; c < 3; ++c) tint[c] *= static_cast<float>(factor[c]);
  if (!texture.colour.texels.empty())
    uses.push_back(
        {.name = "colour",
         .path = add_texture_file(b, name + "Colour", texture.colour, PictureContent::kColour, texture.opacity),
         .is_colour = true,
         .wrap_s = "repeat",
         .wrap_t = "repeat",
         .scale = tint,
         .has_alpha = !texture.opacity.empty()});
  add_normal_map(b, name + "Normal", texture.normal, "repeat", uses);
  if (!texture.surface.texels.empty())
    uses.push_back({.name = "surfaces",
                    .path = add_texture_file(b, name + "Surface", texture.surface, PictureContent::kExact),
                    .wrap_s = "repeat",
                    .wrap_t = "repeat"});
}

// The images of a material, by what they are for.
ImageUses image_uses_of(UsdBuilder& b, const UsdMaterialKey& key) {
  ImageUses uses;
  const Float4 tint = tint_scale(key.tint);
  if (key.primitive.colour_source == ColourSource::kByMarkingAtlas) add_marking_atlas(b, tint, uses);
  if (key.primitive.colour_source == ColourSource::kByAtlas) add_facade_atlas(b, tint, uses);
  if (key.cutout != nullptr) add_cutout(b, *key.cutout, tint, uses);
  if (key.texture != nullptr) add_repeated(b, *key.texture, tint, uses);
  return uses;
}

const ImageUse* use_named(const ImageUses& uses, std::string_view name) {
  const auto found = std::ranges::find(uses, name, &ImageUse::name);
  return found == uses.end() ? nullptr : &*found;
}

// ---- the surface ----

void write_colour(UsdBuilder& b, const std::string& path, const ImageUses& uses) {
  const bool has_image = use_named(uses, "colour") != nullptr;
  b.writer.write({.type = "color3f",
                  .name = "inputs:diffuseColor",
                  .connection = path + (has_image ? "/colour.outputs:rgb" : "/tints.outputs:result")});
  if (!has_image || !use_named(uses, "colour")->has_alpha) return;
  b.writer.write({.type = "float", .name = "inputs:opacity", .connection = path + "/colour.outputs:a"});
  b.writer.write({.type = "float", .name = "inputs:opacityThreshold", .value = 0.5f});
}

void write_roughness(UsdBuilder& b, const std::string& path, const UsdMaterialKey& key, const ImageUses& uses) {
  if (use_named(uses, "surfaces") != nullptr) {
    b.writer.write({.type = "float", .name = "inputs:roughness", .connection = path + "/surfaces.outputs:g"});
    b.writer.write({.type = "float", .name = "inputs:metallic", .connection = path + "/surfaces.outputs:b"});
    return;
  }
  const auto& values = values_of(key.primitive.material);
  b.writer.write({.type = "float", .name = "inputs:roughness", .value = values.roughness});
  b.writer.write({.type = "float", .name = "inputs:metallic", .value = values.metallic});
}

void write_emission(UsdBuilder& b, const std::string& path, const UsdMaterialKey& key, const ImageUses& uses) {
  if (use_named(uses, "emission") != nullptr)
    b.writer.write({.type = "color3f", .name = "inputs:emissiveColor", .connection = path + "/emission.outputs:rgb"});
  else if (key.primitive.colour_source == ColourSource::kByMaterial && emits(key.primitive.material))
    b.writer.write({.type = "color3f", .name = "inputs:emissiveColor", .value = emission_of(key.primitive.material)});
}

void write_material(UsdBuilder& b, const UsdMaterial& material) {
  const std::string path = scope_path() + "/" + material.name;
  const ImageUses uses = image_uses_of(b, material.key);
  b.writer.begin_prim({.type = "Material", .name = material.name});
  b.writer.write({.type = "token", .name = "outputs:surface", .connection = path + "/surface.outputs:surface"});
  b.writer.begin_prim({.type = "Shader", .name = "surface"});
  b.writer.write({.type = "token", .name = "info:id", .value = UsdToken{"UsdPreviewSurface"}, .is_uniform = true});
  write_colour(b, path, uses);
  write_roughness(b, path, material.key, uses);
  write_emission(b, path, material.key, uses);
  if (use_named(uses, "normals") != nullptr)
    b.writer.write({.type = "normal3f", .name = "inputs:normal", .connection = path + "/normals.outputs:rgb"});
  b.writer.write({.type = "token", .name = "outputs:surface"});
  b.writer.end_prim();
  for (const ImageUse& use : uses) write_image(b, path, use);
  if (!uses.empty()) write_reader(b, "st", "UsdPrimvarReader_float2", "float2", "st");
  if (use_named(uses, "colour") == nullptr)
    write_reader(b, "tints", "UsdPrimvarReader_float3", "float3", "displayColor");
  b.writer.end_prim();
}

}  // namespace

std::string material_path(UsdBuilder& b, const Primitive& p, const impostor::Cutout* cutout) {
  const UsdMaterialKey key = key_of_material(b, p, cutout);
  auto found = std::ranges::find(b.materials, key, &UsdMaterial::key);
  if (found == b.materials.end()) {
    b.materials.push_back({key, material_prim_name(b, key)});
    found = std::prev(b.materials.end());
  }
  return scope_path() + "/" + found->name;
}

const impostor::Cutout* shared_cutout(UsdBuilder& b, const impostor::Cutout& cutout) {
  if (cutout.colour.texels.empty()) return nullptr;
  for (const impostor::Cutout* known : b.cutouts)
    if (known == &cutout || *known == cutout) return known;
  b.cutouts.push_back(&cutout);
  return &cutout;
}

const TextureImage* image_of(const UsdBuilder& b, const Primitive& p, const impostor::Cutout* cutout) {
  if (p.uvs.empty()) return nullptr;
  if (p.colour_source == ColourSource::kByMarkingAtlas) return &b.tile.marking_atlas;
  if (p.colour_source == ColourSource::kByAtlas) return &b.tile.facade_atlas.colour;
  if (p.colour_source == ColourSource::kByCutout) return cutout == nullptr ? nullptr : &cutout->colour;
  const materials::Texture* texture = texture_of(b, p);
  return texture == nullptr ? nullptr : &shown_image(*texture);
}

void write_materials(UsdBuilder& b) {
  if (b.materials.empty()) return;
  b.writer.begin_prim({.type = "Scope", .name = "materials"});
  for (const UsdMaterial& material : b.materials) write_material(b, material);
  b.writer.end_prim();
}

}  // namespace citykiln::exporters
