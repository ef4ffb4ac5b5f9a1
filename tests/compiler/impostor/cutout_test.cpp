#include "compiler/impostor/cutout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

TEST(Cutout, IsOpaqueWhereSamplesAreCovered) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Picture picture = chance_picture(40, 30, seed);
    const Cutout cutout = lay_out_cutout({picture}, 0.25).cutout;
    double samples = 0;
    for (const Texel& texel : picture.texels) samples += texel.shown;
    const auto there = std::ranges::count_if(cutout.opacity, [](std::uint8_t o) { return o >= kAlphaCutoff; });
    EXPECT_NEAR(static_cast<double>(there), samples / kSamplesPerTexel, 0.03 * 40 * 30) << seed;
  }
}

TEST(Cutout, HasNoDarkRim) {
  const Cutout cutout = lay_out_cutout({chance_picture(12, 9, 1), chance_picture(5, 20, 2)}, 0.1).cutout;
  ASSERT_EQ(cutout.opacity.size(), cutout.colour.texels.size());
  // frames and uncovered texels have the picture's colour; only the unused rest of the atlas is black
  for (std::size_t i = 0; i < cutout.opacity.size(); ++i) {
    if (cutout.opacity[i] > 0) {
      EXPECT_GT(cutout.colour.texels[i][1], 100);
    }
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
  // and transparent texels beside it
  EXPECT_EQ(layout.cutout.opacity[(row + 0) * layout.cutout.colour.columns + column - 1], 0);
}

TEST(Cutout, OfNothingIsNothing) {
  EXPECT_TRUE(lay_out_cutout({}, 1).cutout.opacity.empty());
  const Cutout cutout = lay_out_cutout({Picture{4, 4, std::vector<Texel>(16)}}, 1).cutout;
  EXPECT_EQ(std::ranges::count(cutout.opacity, std::uint8_t{0}), static_cast<std::ptrdiff_t>(cutout.opacity.size()));
}

}  // namespace
}  // namespace citykiln::impostor
