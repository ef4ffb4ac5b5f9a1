#include "compiler/bake/tiles/join_marking_atlases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compiler/materials/material.h"

namespace citykiln::bake {
namespace {

using materials::TextureImage;

TextureImage made(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed, double texel_m = 0.25) {
  std::mt19937 dice(seed);
  TextureImage atlas{texel_m, columns, rows, {}};
  for (std::uint32_t i = 0; i < columns * rows; ++i)
    atlas.texels.push_back({static_cast<std::uint8_t>(dice()), static_cast<std::uint8_t>(dice()), 1});
  return atlas;
}

Result<JoinedMarkingAtlases> joined_markings(const std::vector<TextureImage>& atlases) {
  std::vector<const TextureImage*> pointers;
  for (const TextureImage& atlas : atlases) pointers.push_back(&atlas);
  return join_marking_atlases(pointers);
}

// A texel as renderers read it: the outermost column continues across, rows repeat along.
TextureImage::Texel texel(const TextureImage& atlas, std::int64_t column, std::uint32_t row) {
  column = std::clamp<std::int64_t>(column, 0, atlas.columns - 1);
  return atlas.texels[row % atlas.rows * atlas.columns + static_cast<std::size_t>(column)];
}

TEST(JoinMarkingAtlases, ShowsEveryAtlasAtItsOffsetWithAGutter) {
  const std::vector<TextureImage> atlases = {made(20, 6, 1), made(7, 4, 2), made(9, 12, 3)};
  const auto all = joined_markings(atlases);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->image.rows, 12u);
  EXPECT_EQ(all->image.texels.size(), std::size_t{all->image.columns} * 12);
  for (std::size_t s = 0; s < atlases.size(); ++s) {
    const double first = all->offsets_m[s] / 0.25;
    ASSERT_EQ(first, std::floor(first));
    const auto columns = static_cast<std::int64_t>(atlases[s].columns);
    for (std::int64_t column = -4; column < columns + 4; ++column)
      for (std::uint32_t row = 0; row < 12; ++row)
        ASSERT_EQ(texel(all->image, static_cast<std::int64_t>(first) + column, row), texel(atlases[s], column, row))
            << s << ": " << column << ", " << row;
  }
}

TEST(JoinMarkingAtlases, StoresEqualAtlasesOnce) {
  const auto all = joined_markings({made(20, 6, 1), made(20, 6, 1), made(20, 6, 1)});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->image, made(20, 6, 1));
  EXPECT_EQ(all->offsets_m, (std::vector<double>{0, 0, 0}));
}

TEST(JoinMarkingAtlases, GivesEmptyAtlasesNoSpace) {
  const auto all = joined_markings({{}, made(20, 6, 1), {}});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->image, made(20, 6, 1));
  EXPECT_EQ(joined_markings({{}, {}})->image, TextureImage{});
}

// The mean of some columns of an atlas in linear light.
double mean_of_columns(const TextureImage& atlas, std::uint32_t first, std::uint32_t count) {
  double sum = 0;
  for (std::uint32_t row = 0; row < atlas.rows; ++row)
    for (std::uint32_t c = first; c < first + count; ++c)
      sum += materials::linear_of_srgb(atlas.texels[row * atlas.columns + c][0]);
  return sum / count / atlas.rows;
}

TEST(JoinMarkingAtlases, ResamplesToTheCoarsestTexels) {
  const TextureImage fine = made(40, 24, 1, 0.25), coarse = made(20, 12, 2, 0.5);
  const auto all = joined_markings({fine, coarse});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->image.texel_m, 0.5);
  EXPECT_EQ(all->image.rows, 12u);
  EXPECT_NEAR(mean_of_columns(all->image, 0, 20), mean_of_columns(fine, 0, 40), 0.005);
  EXPECT_NEAR(mean_of_columns(all->image, 28, 20), mean_of_columns(coarse, 0, 20), 1e-9);
  EXPECT_EQ(all->offsets_m, (std::vector<double>{0, 14}));
}

TEST(JoinMarkingAtlases, ResamplesWhatExceedsTheImageLimits) {
  EXPECT_EQ(joined_markings({made(8184, 2, 1), made(8192, 2, 2)})->image.rows, 2u);
  EXPECT_EQ(joined_markings({made(8185, 2, 1), made(8192, 2, 2)})->image.rows, 1u);
  EXPECT_LE(joined_markings({made(16000, 400, 1), made(16000, 400, 2)})->image.columns, materials::kMaxImageSide_px);
}

TEST(JoinMarkingAtlases, RefusesDifferentLengthsThatDoNotFit) {
  EXPECT_FALSE(joined_markings({made(1, 127, 1), made(1, 131, 2)}));
  EXPECT_FALSE(joined_markings({made(8000, 90, 1), made(8000, 91, 2)}));
}

}  // namespace
}  // namespace citykiln::bake
