#include "compiler/impostor/atlas.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"
#include "compiler/materials/material.h"

namespace citykiln::impostor {
namespace {

Picture random_picture(std::uint64_t seed, std::uint32_t widest) {
  const RandomSequence draw(seed, StableId{}, "picture");
  Picture picture{
      1 + static_cast<std::uint32_t>(draw.below(widest, 0)), 1 + static_cast<std::uint32_t>(draw.below(widest, 1)), {}};
  for (std::uint32_t i = 0; i < picture.columns * picture.rows; ++i) {
    const auto value = [&](std::uint32_t c, std::uint64_t below) { return draw.below(below, 2 + 5 * i + c); };
    picture.texels.push_back({{static_cast<std::uint16_t>(value(0, 65536)), static_cast<std::uint16_t>(value(1, 65536)),
                               static_cast<std::uint16_t>(value(2, 65536))},
                              static_cast<std::uint8_t>(value(3, 256)),
                              static_cast<std::uint8_t>(value(4, 256)),
                              kSamplesPerTexel});
  }
  return picture;
}

std::vector<SharedPicture> all_shared(const std::vector<Picture>& pictures) {
  std::vector<SharedPicture> all;
  for (const Picture& picture : pictures) all.push_back(shared(picture));
  return all;
}

std::vector<Picture> random_pictures(std::size_t count, std::uint32_t widest) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < count; ++i) pictures.push_back(random_picture(i, widest));
  return pictures;
}

struct At {
  std::size_t column, row;
};
At texel_at(const AtlasLayout& layout, std::size_t picture) {
  const double texel_m = layout.atlas.colour.texel_m;
  return {static_cast<std::size_t>(layout.at_m[picture].x / texel_m + 0.5),
          static_cast<std::size_t>(layout.at_m[picture].y / texel_m + 0.5)};
}

TEST(Atlas, ContainsEveryTexel) {
  const std::vector<Picture> pictures = random_pictures(60, 13);
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 0.5);
  const auto& [colour, surface, emission, normal] = layout.atlas;
  EXPECT_TRUE(emission.texels.empty());
  EXPECT_TRUE(normal.texels.empty());
  EXPECT_EQ(colour.texel_m, 0.5);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t y = 0; y < pictures[i].rows; ++y)
      for (std::size_t x = 0; x < pictures[i].columns; ++x) {
        const Texel& texel = pictures[i].texels[y * pictures[i].columns + x];
        const At at = texel_at(layout, i);
        const std::size_t place = (at.row + y) * colour.columns + at.column + x;
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_EQ(colour.texels[place][c], materials::srgb_of_linear(texel.light[c] / 65535.0));
        EXPECT_EQ(surface.texels[place], (materials::TextureImage::Texel{255, texel.roughness, texel.metalness}));
      }
}

// A surface that rises along rows has a normal against them; one that rises down columns, upwards.
TEST(Atlas, HasNormalsIfAnyPictureHasSlopes) {
  std::vector<Picture> pictures = random_pictures(3, 5);
  const auto one = static_cast<std::int16_t>(1 / kSlopeUnit);
  pictures[1].texels[0].slope = {one, 0}, pictures[2].texels[0].slope = {0, one};
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 0.5);
  const materials::TextureImage& normal = layout.atlas.normal;
  ASSERT_EQ(normal.texels.size(), layout.atlas.colour.texels.size());
  const auto first_of = [&](std::size_t picture) {
    const At at = texel_at(layout, picture);
    return normal.texels[at.row * normal.columns + at.column];
  };
  EXPECT_EQ(first_of(0), (materials::TextureImage::Texel{128, 128, 255}));
  EXPECT_EQ(first_of(1), (materials::TextureImage::Texel{37, 128, 218}));
  EXPECT_EQ(first_of(2), (materials::TextureImage::Texel{128, 218, 218}));
}

// By day there is no emission image.
TEST(Atlas, HasEmissionIfAnyPictureEmitsLight) {
  std::vector<Picture> pictures = random_pictures(20, 6);
  pictures[7].texels[0].emission = {65535, 30000, 0};
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 0.5);
  const materials::TextureImage& emission = layout.atlas.emission;
  ASSERT_EQ(emission.texels.size(), layout.atlas.colour.texels.size());
  const At at = texel_at(layout, 7);
  const materials::TextureImage::Texel shines = {255, materials::srgb_of_linear(30000 / 65535.0), 0};
  EXPECT_EQ(emission.texels[at.row * emission.columns + at.column], shines);
  EXPECT_EQ(emission.texels[at.row * emission.columns + at.column + pictures[7].columns + 1],
            materials::TextureImage::Texel{});
}

// Blocks of two by two texels are the texels of the next mip level.
TEST(Atlas, MixesNoTwoPicturesInTheNextMipLevel) {
  const std::vector<Picture> pictures = random_pictures(80, 9);
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 1);
  const std::size_t columns = layout.atlas.colour.columns, rows = layout.atlas.colour.rows;
  ASSERT_EQ(columns % 2 + rows % 2, 0u);
  std::vector<std::size_t> owner(columns / 2 * (rows / 2), pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const At at = texel_at(layout, i);
    for (std::size_t y = at.row - 1; y <= at.row + pictures[i].rows; ++y)
      for (std::size_t x = at.column - 1; x <= at.column + pictures[i].columns; ++x) {
        ASSERT_TRUE(x < columns && y < rows);
        std::size_t& of_block = owner[y / 2 * (columns / 2) + x / 2];
        EXPECT_TRUE(of_block == pictures.size() || of_block == i);
        of_block = i;
      }
  }
}

TEST(Atlas, RepeatsTheOutermostTexelsInFrames) {
  const std::vector<Picture> pictures = {random_picture(7, 6)};
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 1);
  const auto& colour = layout.atlas.colour;
  ASSERT_EQ(colour.texels.size(), std::size_t{colour.columns} * colour.rows);
  ASSERT_GE(colour.rows, pictures[0].rows + 2);
  const auto at = [&](std::size_t x, std::size_t y) { return colour.texels[y * colour.columns + x]; };
  for (std::size_t y = 1; y <= pictures[0].rows; ++y) {
    EXPECT_EQ(at(0, y), at(1, y));
    EXPECT_EQ(at(pictures[0].columns + 1, y), at(pictures[0].columns, y));
  }
}

TEST(Atlas, StoresEqualPicturesOnce) {
  std::vector<Picture> pictures = random_pictures(10, 9);
  const AtlasLayout once = lay_out_atlas(all_shared(pictures), 1);
  for (std::size_t i = 0; i < 10; ++i) pictures.push_back(pictures[i]);
  const AtlasLayout twice = lay_out_atlas(all_shared(pictures), 1);
  EXPECT_EQ(once.atlas, twice.atlas);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(twice.at_m[i], twice.at_m[i + 10]);
}

TEST(Atlas, DoublesTexelsUntilTheBudgetHolds) {
  std::vector<Picture> pictures;
  for (std::uint32_t i = 0; i < 24; ++i) {
    pictures.push_back({1000, 1000, std::vector<Texel>(1000000)});
    pictures.back().texels[i].roughness = 9, pictures.back().texels[i].shown = 1;
  }
  const AtlasLayout layout = lay_out_atlas(all_shared(pictures), 0.5);
  EXPECT_LE(layout.atlas.colour.texels.size(), kMaxAtlasTexels);
  EXPECT_GT(4 * layout.atlas.colour.texels.size(), kMaxAtlasTexels / 2);
  const double doublings = layout.atlas.colour.texel_m / 0.5;
  EXPECT_TRUE(doublings == 2 || doublings == 4 || doublings == 8);
}

TEST(Atlas, IsMostlyPictures) {
  const std::vector<Picture> pictures = random_pictures(300, 60);
  std::uint64_t texels = 0;
  for (const Picture& p : pictures) texels += p.texels.size();
  EXPECT_LT(lay_out_atlas(all_shared(pictures), 1).atlas.colour.texels.size(), 2 * texels);
}

TEST(Atlas, OfNothingIsNone) { EXPECT_EQ(lay_out_atlas({}, 1).atlas, Atlas{}); }

}  // namespace
}  // namespace citykiln::impostor
