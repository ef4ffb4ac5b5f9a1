#include "exporters/gltf/write/encode_pictures.h"

#include <algorithm>
#include <cassert>

#include "exporters/gltf/glb_names.h"

namespace citykiln::exporters {
namespace {

using bake::InstancedMesh;
using Json = nlohmann::json;

// Images with one sampler.
struct ImageGroup {
  int wrap_u, wrap_v;
};
// glTF's numbers
constexpr int kClamp = 33071, kRepeat = 10497, kLinear = 9729, kLinearMipmapLinear = 9987;
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
  add(kGroups[0], kMarkingAtlasImage, f.tile.marking_atlas);
  const impostor::Atlas& facades = f.tile.facade_atlas;
  add(kGroups[1], kFacadeAtlasImage, facades.colour, PictureContent::kAtlas);
  add(kGroups[1], kFacadeSurfaceImage, facades.surface);
  add(kGroups[1], kFacadeEmissionImage, facades.emission, PictureContent::kAtlas);
  add(kGroups[1], kFacadeNormalImage, facades.normal);
  for (const materials::SharedTexture& texture : f.tile.textures) {
    const std::string name(values_of(texture->material).name);
    add(kGroups[2], name + "Colour", texture->colour, PictureContent::kColour, texture->opacity);
    add(kGroups[2], name + "Normal", texture->normal);
    add(kGroups[2], name + "Surface", texture->surface);
  }
  for (const impostor::Cutout* cutout : f.cutouts) {
    add(kGroups[3], kCutoutImage, cutout->colour, PictureContent::kExact, cutout->opacity);
    add(kGroups[3], kCutoutNormalImage, cutout->normal);
  }
  return all;
}

std::size_t add_sampler(GlbBuilder& f, const ImageGroup& group) {
  return f.add(
      "samplers",
      {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", group.wrap_u}, {"wrapT", group.wrap_v}});
}

void add_texture(GlbBuilder& f, std::size_t image, std::size_t sampler) {
  Json texture = {{"sampler", sampler}};
  if (f.pictures() == PictureFormats::kWebp) {
    texture["extensions"][kWebpExtension]["source"] = image;
    f.extensions.insert(kWebpExtension);
  } else {
    texture["source"] = image;
  }
  f.add("textures", std::move(texture));
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

std::size_t picture_number(const GlbBuilder& f, const materials::TextureImage* picture) {
  const std::vector<TileImage> images = images_of_tile(f);
  const auto found = std::ranges::find(images, picture, &TileImage::image);
  assert(found != images.end());
  return static_cast<std::size_t>(found - images.begin());
}

void add_pictures(GlbBuilder& f) {
  const ImageGroup* group = nullptr;
  std::size_t sampler = 0;
  for (const TileImage& each : images_of_tile(f)) {
    if (each.group != group) sampler = add_sampler(f, *(group = each.group));
    const EncodedPicture picture = encode_picture(*each.image, each.opacity, each.content, f.pictures());
    // KHR_texture_transform's scales are rounded
    const std::size_t image = f.add("images", {{"name", each.name},
                                               {"mimeType", picture.mime_type},
                                               {"bufferView", f.add_view(picture.bytes, ViewUse::kOther)},
                                               {"extras", {{"texel_m", each.image->texel_m}}}});
    add_texture(f, image, sampler);
  }
}

}  // namespace citykiln::exporters
