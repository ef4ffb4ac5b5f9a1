#include "preview/imprint_texture.h"

namespace citykiln::preview {
namespace {

constexpr std::size_t kLevels = 2;

}  // namespace

ImprintTexture::ImprintTexture(const imprint::Atlas& atlas)
    : atlas_(&atlas),
      colour_(atlas.colour, Texels::kColours, Sides::kGoOn, kLevels),
      surface_(atlas.surface, Texels::kNumbers, Sides::kGoOn, kLevels) {
  if (!atlas.emission.texels.empty()) emission_.emplace(atlas.emission, Texels::kColours, Sides::kGoOn, kLevels);
  if (!atlas.normal.texels.empty()) normal_.emplace(atlas.normal, Texels::kNormals, Sides::kGoOn, kLevels);
}

Vec3 ImprintTexture::normal(const Patch& patch) const {
  const auto [u, v, out] = normal_->mean(patch);
  return unit(Vec3{u, v, out});
}

}  // namespace citykiln::preview
