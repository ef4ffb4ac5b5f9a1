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
}

}  // namespace citykiln::preview
