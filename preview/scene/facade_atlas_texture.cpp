#include "preview/scene/facade_atlas_texture.h"

namespace citykiln::preview {
namespace {

constexpr std::size_t kFacadeLevels = 2;

}  // namespace

FacadeAtlasTexture::FacadeAtlasTexture(const impostor::Atlas& atlas)
    : atlas_(&atlas),
      colour_(atlas.colour, TexelMeaning::kColours, WrapMode::kClamp, kFacadeLevels),
      surface_(atlas.surface, TexelMeaning::kNumbers, WrapMode::kClamp, kFacadeLevels) {
  if (!atlas.emission.texels.empty())
    emission_.emplace(atlas.emission, TexelMeaning::kColours, WrapMode::kClamp, kFacadeLevels);
  if (!atlas.normal.texels.empty())
    normal_.emplace(atlas.normal, TexelMeaning::kNormals, WrapMode::kClamp, kFacadeLevels);
}

std::size_t FacadeAtlasTexture::bytes() const {
  return colour_.bytes() + surface_.bytes() + (emission_ ? emission_->bytes() : 0) + (normal_ ? normal_->bytes() : 0);
}

Vec3 FacadeAtlasTexture::normal(const TextureFootprint& footprint, const TexelRectangle& picture) const {
  const auto [u, v, out] = normal_->mean(footprint, picture);
  return unit(Vec3{u, v, out});
}

}  // namespace citykiln::preview
