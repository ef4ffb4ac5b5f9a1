#include "exporters/gltf/encode_pictures.h"

#include <algorithm>
#include <cassert>

namespace citykiln::exporters {
namespace {

using bake::InstancedMesh;
using tinygltf::Value;

// Images with one sampler.
struct ImageGroup {
  int wrap_u, wrap_v;
};
constexpr int kClamp = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, kRepeat = TINYGLTF_TEXTURE_WRAP_REPEAT;
// Marking atlas (its strips lie side by side, so it repeats along v only), facade atlas, textures, cutouts.
constexpr ImageGroup kGroups[] = {{kClamp, kRepeat}, {kClamp, kClamp}, {kRepeat, kRepeat}, {kClamp, kClamp}};

struct TileImage {
  const ImageGroup* group;
  std::string name;
  const materials::TextureImage* image;
  PictureContent content = PictureContent::kExact;
  std::span<const std::uint8_t> opacity{};  ///< Empty, or one per texel.
};

// All images that have texels, in the order of the file.
std::vector<TileImage> images_of_tile(const GlbBuilder& f) {
  std::vector<TileImage> all;
  const auto add = [&](const ImageGroup& group, const std::string& name, const materials::TextureImage& image,
                       PictureContent content = PictureContent::kExact, std::span<const std::uint8_t> opacity = {}) {
    if (!image.texels.empty()) all.push_back({&group, name, &image, content, opacity});
  };
  add(kGroups[0], "marking_atlas", f.tile.marking_atlas);
  const impostor::Atlas& facades = f.tile.facade_atlas;
  add(kGroups[1], "facade_atlas", facades.colour, PictureContent::kAtlas);
  add(kGroups[1], "facade_atlas_surface", facades.surface);
  add(kGroups[1], "facade_atlas_emission", facades.emission, PictureContent::kAtlas);
  add(kGroups[1], "facade_atlas_normal", facades.normal);
  for (const materials::Texture& texture : f.tile.textures) {
    const std::string name(values_of(texture.material).name);
    add(kGroups[2], name + "Colour", texture.colour, PictureContent::kColour);
    add(kGroups[2], name + "Normal", texture.normal);
  }
  for (const impostor::Cutout* cutout : f.cutouts) {
    add(kGroups[3], "cutout", cutout->colour, PictureContent::kExact, cutout->opacity);
    add(kGroups[3], "cutoutNormal", cutout->normal);
  }
  return all;
}

int add_sampler(GlbBuilder& f, const ImageGroup& group) {
  tinygltf::Sampler sampler;
  sampler.wrapS = group.wrap_u, sampler.wrapT = group.wrap_v;
  sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
  sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  f.model.samplers.push_back(sampler);
  return static_cast<int>(f.model.samplers.size()) - 1;
}

// Adds the texture of the image that is added next.
void add_texture_of_next_image(GlbBuilder& f, int sampler) {
  tinygltf::Texture texture;
  texture.sampler = sampler;
  const auto source = static_cast<int>(f.model.images.size());
  if (f.pictures() == PictureFormats::kWebp) {
    texture.extensions[kWebpExtension] = Value(Value::Object{{"source", Value(source)}});
    f.extensions.insert(kWebpExtension);
  } else {
    texture.source = source;
  }
  f.model.textures.push_back(texture);
}

}  // namespace

void find_cutouts(GlbBuilder& f) {
  for (const InstancedMesh& instanced : f.tile.instanced)
    if (!instanced.cutout->colour.texels.empty() && cutout_like(f, *instanced.cutout) == nullptr)
      f.cutouts.push_back(&*instanced.cutout);
}

const impostor::Cutout* cutout_like(const GlbBuilder& f, const impostor::Cutout& cutout) {
  const auto found =
      std::ranges::find_if(f.cutouts, [&](const auto* other) { return other == &cutout || *other == cutout; });
  return found == f.cutouts.end() ? nullptr : *found;
}

int picture_number(const GlbBuilder& f, const materials::TextureImage* picture) {
  const std::vector<TileImage> images = images_of_tile(f);
  const auto found = std::ranges::find(images, picture, &TileImage::image);
  assert(found != images.end());
  return static_cast<int>(found - images.begin());
}

void add_pictures(GlbBuilder& f) {
  const ImageGroup* group = nullptr;
  int sampler = -1;
  for (const TileImage& each : images_of_tile(f)) {
    if (each.group != group) sampler = add_sampler(f, *(group = each.group));
    EncodedPicture picture = encode_picture(*each.image, each.opacity, each.content, f.pictures());
    tinygltf::Image image;
    image.name = each.name, image.mimeType = picture.mime_type, image.bufferView = f.add_view(picture.bytes, 0);
    // KHR_texture_transform's scales are rounded
    image.extras = Value(Value::Object{{"texel_m", Value(each.image->texel_m)}});
    add_texture_of_next_image(f, sampler);
    f.model.images.push_back(image);
  }
}

}  // namespace citykiln::exporters
