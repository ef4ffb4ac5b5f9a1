#include "exporters/gltf/read/decode_pictures.h"

#include <algorithm>
#include <string_view>

#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/material_names.h"
#include "exporters/gltf/pictures/picture_formats.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using materials::ColourSource;

// Texel sizes are in the images' extras, since scales are rounded.
double stated_texel_m(const tinygltf::Image& image) {
  const double texel_m = number(member(image.extras, "texel_m"));
  expect(texel_m > 0 && std::isfinite(texel_m), "texels with a size");
  return texel_m;
}

CutoutImage cutout_image_in(GltfReader& reader, const tinygltf::Image& image) {
  auto picture = decode_picture(std::as_bytes(bytes_of(reader, image.bufferView)), "");
  if (!picture) throw FormatError{"a picture: " + to_string(picture.error())};
  picture->colour.texel_m = stated_texel_m(image);
  return std::move(*picture);
}

materials::TextureImage read_picture(GltfReader& reader, const tinygltf::Image& image) {
  return cutout_image_in(reader, image).colour;
}

// The texture that an image belongs to: the last one, or a new one.
materials::Texture& texture_with(std::vector<materials::Texture>& textures, std::string_view name) {
  const auto material = material_named(name);
  expect(material.has_value(), "images named after materials, and one marking atlas at most");
  if (!textures.empty() && textures.back().material == *material) return textures.back();
  expect(textures.empty() || textures.back().material < *material, "each material's pictures once, in order");
  return textures.emplace_back(materials::Texture{*material, {}, {}, {}});
}

// The image of a texture that a name's end stands for, and whether it may follow those that the texture has.
struct TextureSlot {
  materials::TextureImage* image;
  bool is_next;
};
TextureSlot slot_of(materials::Texture& texture, char first) {
  const bool has_normal = !texture.normal.texels.empty(), has_surface = !texture.surface.texels.empty();
  if (first == 'C') return {&texture.colour, texture.colour.texels.empty() && !has_normal && !has_surface};
  if (first == 'N') return {&texture.normal, !has_normal && !has_surface};
  return {&texture.surface, !has_surface};
}

void read_texture(GltfReader& reader, const tinygltf::Image& image, std::vector<materials::Texture>& textures) {
  const auto coloured = strip_suffix(image.name, "Colour"), shaped = strip_suffix(image.name, "Normal"),
             rough = strip_suffix(image.name, "Surface");
  expect(coloured || shaped || rough, "images named after materials, and one marking atlas at most");
  materials::Texture& texture = texture_with(textures, coloured ? *coloured : shaped ? *shaped : *rough);
  const TextureSlot slot = slot_of(texture, coloured ? 'C' : shaped ? 'N' : 'S');
  expect(slot.is_next, "each material's pictures once, in order");
  CutoutImage picture = cutout_image_in(reader, image);
  *slot.image = std::move(picture.colour);
  if (coloured && materials::has_holes(texture.material)) texture.opacity = std::move(picture.opacity);
  expect(slot.image->columns == slot.image->rows, "textures that are square");
}

// Reads a cutout: its colours, and its normals if these follow.
impostor::Cutout read_cutout(GltfReader& reader, std::size_t image) {
  const auto& images = reader.model.images;
  CutoutImage picture = cutout_image_in(reader, images[image]);
  impostor::Cutout cutout{std::move(picture.colour), std::move(picture.opacity), {}};
  if (image + 1 < images.size() && images[image + 1].name == kCutoutNormalImage)
    cutout.normal = read_picture(reader, images[image + 1]);
  return cutout;
}

// Reads the cutouts, from image `first` on.
void read_cutouts(GltfReader& reader, std::size_t first, std::span<const std::optional<std::size_t>> wanted,
                  BakedTile& tile) {
  const auto& images = reader.model.images;
  for (std::size_t i = first; i < images.size(); ++i) {
    if (images[i].name == kCutoutNormalImage && i > first && images[i - 1].name == kCutoutImage) continue;
    expect(images[i].name == kCutoutImage, "images named after materials, and one marking atlas at most");
    const impostor::SharedCutout cutout(read_cutout(reader, i));
    for (std::size_t k = 0; k < wanted.size(); ++k)
      if (wanted[k] == i) tile.instanced[k].cutout = cutout;
  }
}

// The image of a texture, in any of its formats.
int image_of_texture(const tinygltf::Texture& texture) {
  const auto webp = texture.extensions.find(kWebpExtension);
  return webp == texture.extensions.end() ? texture.source : whole(member(webp->second, "source"));
}

bool are_one_size(const impostor::Atlas& atlas) {
  // clang before 16 cannot capture structured bindings
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
    const int image = image_of_texture(item(model.textures, texture, "a texture that exists"));
    expect(item(model.images, image, "a picture that exists").name == kCutoutImage, "a cutout image");
    expect(!number || *number == static_cast<std::size_t>(image), "one cutout a mesh");
    number = static_cast<std::size_t>(image);
  }
  return number;
}

void read_pictures(GltfReader& reader, std::span<const std::optional<std::size_t>> cutouts, BakedTile& tile) {
  const std::pair<const char*, materials::TextureImage*> images_of_tile[] = {
      {kMarkingAtlasImage, &tile.marking_atlas},
      {kFacadeAtlasImage, &tile.facade_atlas.colour},
      {kFacadeSurfaceImage, &tile.facade_atlas.surface},
      {kFacadeEmissionImage, &tile.facade_atlas.emission},
      {kFacadeNormalImage, &tile.facade_atlas.normal}};
  const auto& images = reader.model.images;
  std::size_t i = 0;
  for (const auto& [name, target] : images_of_tile)
    if (i < images.size() && images[i].name == name) *target = read_picture(reader, images[i++]);
  std::vector<materials::Texture> textures;
  for (; i < images.size() && images[i].name != kCutoutImage; ++i) read_texture(reader, images[i], textures);
  for (materials::Texture& texture : textures) tile.textures.emplace_back(std::move(texture));
  read_cutouts(reader, i, cutouts, tile);
  expect(are_one_size(tile.facade_atlas), "a facade atlas whose images are of one size");
}

}  // namespace citykiln::exporters
