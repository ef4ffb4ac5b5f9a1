#include "compiler/impostor/cutout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "compiler/impostor/atlas.h"

namespace citykiln::impostor {
namespace {

using Counts = std::array<std::int64_t, kSamplesPerTexel + 1>;

// The number of covered samples from which a texel is opaque, so that the opaque area is closest to the covered area.
std::uint32_t least_opaque(const Picture& picture) {
  Counts counts{};
  std::int64_t samples = 0;
  for (const Texel& texel : picture.texels) ++counts[texel.shown], samples += texel.shown;
  std::uint32_t best = kSamplesPerTexel;
  std::int64_t opaque = 0, least_difference = samples;
  for (std::uint32_t shown = kSamplesPerTexel; shown > 0; --shown) {
    opaque += counts[shown];
    const std::int64_t difference = std::abs(opaque * kSamplesPerTexel - samples);
    if (difference < least_difference) least_difference = difference, best = shown;
  }
  return best;
}

std::uint8_t opacity_of(std::uint32_t shown, std::uint32_t least) {
  const double share = shown / (least - 0.5);
  return static_cast<std::uint8_t>(std::min(255.0, std::floor(share * (kAlphaCutoff - 0.5) + 0.5)));
}

void draw(const Picture& picture, Vec2 at_m, Cutout& cutout) {
  const auto column = static_cast<std::size_t>(std::floor(at_m.x / cutout.colour.texel_m + 0.5)),
             row = static_cast<std::size_t>(std::floor(at_m.y / cutout.colour.texel_m + 0.5));
  const std::uint32_t least = least_opaque(picture);
  for (std::size_t y = 0; y < picture.rows; ++y)
    for (std::size_t x = 0; x < picture.columns; ++x)
      cutout.opacity[(row + y) * cutout.colour.columns + column + x] =
          opacity_of(picture.texels[y * picture.columns + x].shown, least);
}

}  // namespace

CutoutLayout lay_out_cutout(std::vector<Picture> pictures, double texel_m) {
  assert(texel_m > 0);
  std::vector<Picture> filled = pictures;
  for (Picture& picture : filled) fill_gaps(picture);
  AtlasLayout layout = lay_out_atlas(filled, texel_m);
  CutoutLayout out{{std::move(layout.atlas.colour), {}, {}}, std::move(layout.at_m)};
  out.cutout.opacity.assign(out.cutout.colour.texels.size(), 0);
  // the atlas may have halved the pictures to fit
  for (double made_m = texel_m; made_m < out.cutout.colour.texel_m; made_m *= 2)
    for (Picture& picture : pictures) picture = halved(picture);
  for (std::size_t i = 0; i < pictures.size(); ++i) draw(pictures[i], out.at_m[i], out.cutout);
  return out;
}

}  // namespace citykiln::impostor
