#include "exporters/gltf/decode_pictures.h"

#include <algorithm>
#include <string_view>

#include "exporters/gltf/material_names.h"
#include "exporters/gltf/png.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using materials::ColourSource;

// The size of a texel stands beside the picture.
double texel_m_of(const tinygltf::Image& image) {
  const double texel_m = number(member(image.extras, "texel_m"));
  expect(texel_m > 0 && std::isfinite(texel_m), "texels with a size");
  return texel_m;
}

materials::TextureImage picture_of(GltfReader& source, const tinygltf::Image& image) {
  auto picture = decode_png(std::as_bytes(bytes_of(source, image.bufferView)), "");
  if (!picture) throw FormatError{"a picture: " + to_string(picture.error())};
  picture->texel_m = texel_m_of(image);
  return std::move(*picture);
}

// The texture that a picture belongs to: the last one, or the next.
materials::Texture& texture_with(std::vector<materials::Texture>& textures, std::string_view name) {
  const auto material = material_named(name);
  expect(material.has_value(), "pictures named after materials, and one sheet at most");
  if (!textures.empty() && textures.back().material == *material) return textures.back();
  expect(textures.empty() || textures.back().material < *material, "each material's pictures once, in order");
  return textures.emplace_back(materials::Texture{*material, {}, {}});
}

void read_texture(GltfReader& source, const tinygltf::Image& image, std::vector<materials::Texture>& textures) {
  const auto colour_source = strip_suffix(image.name, "Colour"), shaped = strip_suffix(image.name, "Normal");
  expect(colour_source || shaped, "pictures named after materials, and one sheet at most");
  materials::Texture& texture = texture_with(textures, colour_source ? *colour_source : *shaped);
  materials::TextureImage& place = colour_source ? texture.colour : texture.normal;
  expect(place.texels.empty() && (shaped || texture.normal.texels.empty()), "each material's pictures once, in order");
  place = picture_of(source, image);
  expect(place.columns == place.rows, "textures that are square");
}

// A cutout: its colours, and its normals where these follow.
impostor::Cutout read_cutout(GltfReader& source, std::size_t image) {
  const auto& images = source.model.images;
  const auto bytes = std::as_bytes(bytes_of(source, images[image].bufferView));
  auto picture = decode_cutout_png(bytes, "");
  if (!picture) throw FormatError{"a picture: " + to_string(picture.error())};
  impostor::Cutout cutout{std::move(picture->colour), std::move(picture->opacity), {}};
  cutout.colour.texel_m = texel_m_of(images[image]);
  if (image + 1 < images.size() && images[image + 1].name == "cutoutNormal")
    cutout.normal = picture_of(source, images[image + 1]);
  return cutout;
}

// From `first` on. Meshes may share them, each with a copy of its own: a small file must not make a large tile.
void read_cutouts(GltfReader& source, std::size_t first, std::span<const std::optional<std::size_t>> wanted,
                  BakedTile& tile) {
  const auto& images = source.model.images;
  std::uint64_t texels = 0;
  for (std::size_t i = first; i < images.size(); ++i) {
    if (images[i].name == "cutoutNormal" && i > first && images[i - 1].name == "cutout") continue;
    expect(images[i].name == "cutout", "pictures named after materials, and one sheet at most");
    const impostor::Cutout cutout = read_cutout(source, i);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (wanted[k] != i) continue;
      texels += cutout.colour.texels.size() + cutout.normal.texels.size();
      expect(texels <= materials::kMaxImageTexels, "no more cutouts than a sheet has texels");
      tile.instanced[k].cutout = cutout;
    }
  }
}

bool are_one_size(const impostor::Atlas& atlas) {
  // by its name: clang before 16 lets no lambda have what a structured binding names
  const materials::TextureImage& colour = atlas.colour;
  const auto is_as_large = [&](const materials::TextureImage& other) {
    return colour.columns == other.columns && colour.rows == other.rows && colour.texel_m == other.texel_m;
  };
  return is_as_large(atlas.surface) && (atlas.emission.texels.empty() || is_as_large(atlas.emission)) &&
         (atlas.normal.texels.empty() || is_as_large(atlas.normal));
}

}  // namespace

std::optional<std::size_t> cutout_image_of(const tinygltf::Model& model, int mesh) {
  std::optional<std::size_t> number;
  for (const tinygltf::Primitive& p : item(model.meshes, mesh, "a mesh that exists").primitives) {
    const tinygltf::Material& m = item(model.materials, p.material, "a material that exists");
    if (primitive_key_named(m.name).colour_source != ColourSource::kByCutout) continue;
    const int texture = m.pbrMetallicRoughness.baseColorTexture.index;
    const int image = item(model.textures, texture, "a texture that exists").source;
    expect(item(model.images, image, "a picture that exists").name == "cutout", "leaves on a cutout");
    expect(!number || *number == static_cast<std::size_t>(image), "one cutout a mesh");
    number = static_cast<std::size_t>(image);
  }
  return number;
}

void read_pictures(GltfReader& source, std::span<const std::optional<std::size_t>> cutouts, BakedTile& tile) {
  const std::pair<const char*, materials::TextureImage*> sheets[] = {{"marking_atlas", &tile.sheet},
                                                                     {"facade_atlas", &tile.facade_atlas.colour},
                                                                     {"facade_atlas_surface", &tile.facade_atlas.surface},
                                                                     {"facade_atlas_emission", &tile.facade_atlas.emission},
                                                                     {"facade_atlas_normal", &tile.facade_atlas.normal}};
  const auto& images = source.model.images;
  std::size_t i = 0;
  for (const auto& [name, place] : sheets)
    if (i < images.size() && images[i].name == name) *place = picture_of(source, images[i++]);
  for (; i < images.size() && images[i].name != "cutout"; ++i) read_texture(source, images[i], tile.textures);
  read_cutouts(source, i, cutouts, tile);
  expect(are_one_size(tile.facade_atlas), "an atlas whose pictures are of one size");
}

}  // namespace citykiln::exporters
