#include "compiler/bake/tiles/join_facade_atlases.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"

namespace citykiln::bake {
namespace {

using impostor::Atlas;
using materials::TextureImage;

Atlas made_atlas(std::uint64_t seed, double texel_m, std::uint32_t columns, std::uint32_t rows) {
  const RandomSequence draw(seed, StableId{}, "atlas");
  Atlas atlas{{texel_m, columns, rows, {}}, {texel_m, columns, rows, {}}, {}, {}};
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    atlas.colour.texels.push_back({static_cast<std::uint8_t>(draw.below(256, 2 * i)), 7, 9});
    atlas.surface.texels.push_back({255, static_cast<std::uint8_t>(draw.below(256, 2 * i + 1)), 0});
  }
  // some shine
  if (seed % 2 == 1) atlas.emission = atlas.colour;
  if (seed % 3 == 1) atlas.normal = atlas.surface;
  return atlas;
}

JoinedFacadeAtlases joined_facades(const std::vector<Atlas>& atlases) {
  std::vector<const Atlas*> pointers;
  for (const Atlas& atlas : atlases) pointers.push_back(&atlas);
  return join_facade_atlases(pointers);
}

// The texel at a place in metres.
TextureImage::Texel at(const TextureImage& image, Vec2 uv) {
  const auto column = static_cast<std::size_t>(uv.x / image.texel_m),
             row = static_cast<std::size_t>(uv.y / image.texel_m);
  return image.texels.at(row * image.columns + column);
}

void expect_all_there(const std::vector<Atlas>& atlases) {
  const JoinedFacadeAtlases all = joined_facades(atlases);
  ASSERT_EQ(all.places.size(), atlases.size());
  for (std::size_t i = 0; i < atlases.size(); ++i)
    for (std::size_t t = 0; t < atlases[i].colour.texels.size(); ++t) {
      const TextureImage& own = atlases[i].colour;
      const Vec2 uv = Vec2{t % own.columns + 0.5, t / own.columns + 0.5} * own.texel_m;
      const Vec2 there = all.places[i].at_m + uv * all.places[i].scale;
      EXPECT_EQ(at(all.atlas.colour, there), own.texels[t]);
      EXPECT_EQ(at(all.atlas.surface, there), atlases[i].surface.texels[t]);
      const bool leans = !atlases[i].normal.texels.empty();
      EXPECT_EQ(at(all.atlas.normal, there),
                leans ? atlases[i].normal.texels[t] : (TextureImage::Texel{128, 128, 255}));
    }
}

TEST(JoinFacadeAtlases, ContainsEveryTexel) {
  expect_all_there({made_atlas(1, 0.5, 12, 20), made_atlas(2, 0.5, 30, 8)});
}

TEST(JoinFacadeAtlases, ContainsEveryTexelOfDifferentTolerances) {
  expect_all_there({made_atlas(1, 12.5, 12, 20), made_atlas(2, 0.5, 30, 8), Atlas{}, made_atlas(3, 2.5, 6, 6)});
}

TEST(JoinFacadeAtlases, PutsHighAtlasesSideBySide) {
  expect_all_there({made_atlas(1, 0.5, 4, 10000), made_atlas(2, 0.5, 8, 10000), made_atlas(3, 0.5, 2, 10)});
}

TEST(JoinFacadeAtlases, HalvesWhatExceedsTheImageLimits) {
  std::vector<Atlas> atlases;
  for (int i = 0; i < 5; ++i) {
    const TextureImage grey{0.5, 4096, 4096,
                            std::vector<TextureImage::Texel>(4096 * 4096, TextureImage::Texel{60, 60, 60})};
    atlases.push_back({grey, grey, {}, {}});
  }
  const JoinedFacadeAtlases all = joined_facades(atlases);
  EXPECT_LE(all.atlas.colour.texels.size(), materials::kMaxImageTexels);
  EXPECT_EQ(all.atlas.colour.texel_m, 1);
  // a place is as many metres from the atlas's corner as it was
  EXPECT_EQ(all.places[4].scale, 1);
  EXPECT_EQ(at(all.atlas.colour, all.places[4].at_m + Vec2{2047, 2047}), (TextureImage::Texel{60, 60, 60}));
}

TEST(JoinFacadeAtlases, IsEmptyForNoAtlases) { EXPECT_EQ(joined_facades({Atlas{}, Atlas{}}).atlas, Atlas{}); }

}  // namespace
}  // namespace citykiln::bake
