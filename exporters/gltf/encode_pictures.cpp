#include "exporters/gltf/encode_pictures.h"

#include <algorithm>

#include "exporters/gltf/png.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::InstancedMesh;
using tinygltf::Value;

int add_sampler(GlbBuilder& f, int wrap_across, int wrap_along) {
  tinygltf::Sampler sampler;
  sampler.wrapS = wrap_across, sampler.wrapT = wrap_along;
  sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
  sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  f.model.samplers.push_back(sampler);
  return static_cast<int>(f.model.samplers.size()) - 1;
}

// A picture, its texels' size beside it: what scale it has is rounded. @param opacity  None, or one a texel.
void add_picture(GlbBuilder& f, const materials::TextureImage& picture, const std::string& name, int sampler,
                 std::span<const std::uint8_t> opacity = {}) {
  if (picture.texels.empty()) return;
  tinygltf::Image image;
  image.name = name, image.mimeType = "image/png";
  image.bufferView = f.add_view(opacity.empty() ? encode_png(picture) : encode_png(picture, opacity), 0);
  image.extras = Value(Value::Object{{"texel_m", Value(picture.texel_m)}});
  tinygltf::Texture texture;
  texture.sampler = sampler, texture.source = static_cast<int>(f.model.images.size());
  f.model.images.push_back(image), f.model.textures.push_back(texture);
}

void add_textures(GlbBuilder& f) {
  if (f.tile.textures.empty()) return;
  const int repeating = add_sampler(f, TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_REPEAT);
  for (const materials::Texture& texture : f.tile.textures) {
    const std::string name(values_of(texture.material).name);
    add_picture(f, texture.colour, name + "Colour", repeating);
    add_picture(f, texture.normal, name + "Normal", repeating);
  }
}

}  // namespace

void find_cutouts(GlbBuilder& f) {
  for (const InstancedMesh& instanced : f.tile.instanced) {
    const auto is_alike = [&](const impostor::Cutout* other) { return *other == instanced.cutout; };
    if (!instanced.cutout.colour.texels.empty() && std::ranges::none_of(f.cutouts, is_alike))
      f.cutouts.push_back(&instanced.cutout);
  }
}

const impostor::Cutout* cutout_like(const GlbBuilder& f, const impostor::Cutout& cutout) {
  const auto is_alike = [&](const impostor::Cutout* other) { return *other == cutout; };
  const auto found = std::ranges::find_if(f.cutouts, is_alike);
  return found == f.cutouts.end() ? nullptr : *found;
}

int picture_number(const GlbBuilder& f, const materials::TextureImage* picture) {
  const BakedTile& tile = f.tile;
  int number = 0;
  const auto is_it = [&](const materials::TextureImage& other) {
    if (&other == picture) return true;
    number += other.texels.empty() ? 0 : 1;
    return false;
  };
  const impostor::Atlas& atlas = tile.facade_atlas;
  if (is_it(tile.sheet) || is_it(atlas.colour) || is_it(atlas.surface) || is_it(atlas.emission) || is_it(atlas.normal))
    return number;
  for (const materials::Texture& texture : tile.textures)
    if (is_it(texture.colour) || is_it(texture.normal)) return number;
  for (const impostor::Cutout* cutout : f.cutouts)
    if (is_it(cutout->colour) || is_it(cutout->normal)) break;
  return number;
}

void add_pictures(GlbBuilder& f) {
  // strips lie side by side, so that the sheet repeats along v alone
  if (!f.tile.sheet.texels.empty())
    add_picture(f, f.tile.sheet, "marking_atlas",
                add_sampler(f, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, TINYGLTF_TEXTURE_WRAP_REPEAT));
  if (!f.tile.facade_atlas.colour.texels.empty()) {
    const int clamped = add_sampler(f, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE);
    add_picture(f, f.tile.facade_atlas.colour, "facade_atlas", clamped);
    add_picture(f, f.tile.facade_atlas.surface, "facade_atlas_surface", clamped);
    add_picture(f, f.tile.facade_atlas.emission, "facade_atlas_emission", clamped);
    add_picture(f, f.tile.facade_atlas.normal, "facade_atlas_normal", clamped);
  }
  add_textures(f);
  if (f.cutouts.empty()) return;
  const int clamped = add_sampler(f, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE);
  for (const impostor::Cutout* cutout : f.cutouts) {
    add_picture(f, cutout->colour, "cutout", clamped, cutout->opacity);
    add_picture(f, cutout->normal, "cutoutNormal", clamped);
  }
}

}  // namespace citykiln::exporters
