#include "compiler/impostor/cutout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <set>

#include "tests/compiler/impostor/mip_levels.h"

namespace citykiln::impostor {
namespace {

// Texels with random numbers of covered samples.
Picture chance_picture(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed) {
  std::mt19937 dice(seed);
  Picture picture{columns, rows, {}};
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    const auto shown = static_cast<std::uint8_t>(dice() % 3 == 0 ? 0 : dice() % (kSamplesPerTexel + 1));
    Texel texel{{20000, 40000, 9000}, 200, 0, shown};
    picture.texels.push_back(shown == 0 ? Texel{} : texel);
  }
  return picture;
}

// A picture of patches of 5 × 5 equal texels.
Picture patched_picture(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed) {
  const Picture patches = chance_picture(columns, rows, seed);
  Picture picture = patches;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      picture.texels[row * columns + column] = patches.texels[row / 5 * columns + column / 5];
  return picture;
}

TEST(Cutout, IsOpaqueWhereSamplesAreCovered) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Picture picture = patched_picture(40, 30, seed);
    const Cutout cutout = lay_out_cutout({picture}, 0.25).cutout;
    double samples = 0;
    for (const Texel& texel : picture.texels) samples += texel.shown;
    const MipLevel shown{cutout.colour.columns, cutout.colour.rows, cutout.opacity};
    EXPECT_NEAR(interpolated_share(shown) * static_cast<double>(cutout.opacity.size()), samples / kSamplesPerTexel,
                0.05 * 40 * 30)
        << seed;
  }
}

TEST(Cutout, HasNoDarkRim) {
  const Cutout cutout = lay_out_cutout({chance_picture(12, 9, 1), chance_picture(5, 20, 2)}, 0.1).cutout;
  ASSERT_EQ(cutout.opacity.size(), cutout.colour.texels.size());
  ASSERT_FALSE(cutout.opacity.empty());
  for (const materials::TextureImage::Texel& texel : cutout.colour.texels) EXPECT_GT(texel[1], 100);
}

TEST(Cutout, HasSidesThatArePowersOfTwoAndPicturesInCellsOfTheirOwn) {
  std::vector<Picture> pictures;
  for (std::uint32_t i = 0; i < 9; ++i) pictures.push_back(chance_picture(10 + 7 * i, 62, i));
  const CutoutLayout layout = lay_out_cutout(pictures, 1);
  EXPECT_TRUE(std::has_single_bit(layout.cutout.colour.columns));
  EXPECT_TRUE(std::has_single_bit(layout.cutout.colour.rows));
  std::set<std::pair<int, int>> taken;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto first = [](double at) { return static_cast<int>(at - 1) / static_cast<int>(kCell_px); };
    const auto last = [](double at, std::uint32_t side) {
      return static_cast<int>(at + side) / static_cast<int>(kCell_px);
    };
    const Vec2 at = layout.at_m[i];
    for (int row = first(at.y); row <= last(at.y, pictures[i].rows); ++row)
      for (int column = first(at.x); column <= last(at.x, pictures[i].columns); ++column)
        EXPECT_TRUE(taken.emplace(column, row).second) << i;
  }
}

TEST(Cutout, HasPicturesAtTheirPositions) {
  const Picture full{3, 2, std::vector<Texel>(6, Texel{{65535, 0, 0}, 255, 0, kSamplesPerTexel})};
  const CutoutLayout layout = lay_out_cutout({full, chance_picture(7, 7, 3)}, 0.5);
  const auto column = static_cast<std::size_t>(layout.at_m[0].x / 0.5),
             row = static_cast<std::size_t>(layout.at_m[0].y / 0.5);
  for (std::size_t y = 0; y < 2; ++y)
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t at = (row + y) * layout.cutout.colour.columns + column + x;
      EXPECT_GE(layout.cutout.opacity[at], kAlphaCutoff);
      EXPECT_EQ(layout.cutout.colour.texels[at], (materials::TextureImage::Texel{255, 0, 0}));
    }
}

TEST(Cutout, OfNothingIsNothing) {
  EXPECT_TRUE(lay_out_cutout({}, 1).cutout.opacity.empty());
  const Cutout cutout = lay_out_cutout({Picture{4, 4, std::vector<Texel>(16)}}, 1).cutout;
  EXPECT_EQ(std::ranges::count(cutout.opacity, std::uint8_t{0}), 16 * 16);
}

}  // namespace
}  // namespace citykiln::impostor
