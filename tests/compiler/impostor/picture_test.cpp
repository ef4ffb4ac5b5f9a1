#include "compiler/impostor/picture.h"

#include <gtest/gtest.h>

namespace citykiln::impostor {
namespace {

Texel grey(std::uint16_t light, std::uint8_t shown = kSamplesPerTexel) {
  return {{light, light, light}, static_cast<std::uint8_t>(light / 100), 0, shown};
}

TEST(Picture, HasAMeanWeightedByCoverage) {
  EXPECT_EQ(mean({2, 1, {grey(1000), grey(3000)}}).light[0], 2000);
  EXPECT_EQ(mean({2, 1, {grey(1000, 12), grey(3000, 4)}}).light[0], 1500);
  EXPECT_EQ(mean({2, 1, {grey(1000), Texel{}}}).light[0], 1000);
  EXPECT_EQ(mean({2, 1, {Texel{}, Texel{}}}), Texel{});
}

TEST(Picture, KeepsItsMeanWhenHalved) {
  const Picture picture{4, 2, {grey(0), grey(4000), grey(100), grey(100), grey(0), grey(4000), grey(300), grey(300)}};
  const Picture half = halved(picture);
  EXPECT_EQ(half.columns, 2u);
  EXPECT_EQ(half.texels, (std::vector<Texel>{grey(2000), grey(200)}));
  EXPECT_EQ(mean(half), mean(picture));
}

TEST(Picture, HasTheMeanSlopeOfAllTexels) {
  Picture picture{2, 2, {grey(0), grey(0), grey(0), grey(0)}};
  picture.texels[0].slope = {400, -100}, picture.texels[3].slope = {-200, -102};
  EXPECT_EQ(mean(picture).slope, (std::array<std::int16_t, 2>{50, -51}));
}

TEST(Picture, RoundsSizesUpWhenHalved) {
  const Picture half = halved({3, 1, {grey(1000), grey(3000), grey(500)}});
  EXPECT_EQ(half.columns, 2u);
  EXPECT_EQ(half.rows, 1u);
  // half of each texel lies beyond the picture
  EXPECT_EQ(half.texels, (std::vector<Texel>{grey(2000, 8), grey(500, 4)}));
}

TEST(Picture, FillsGapsWithTheMean) {
  Picture picture{3, 1, {grey(1000), Texel{}, grey(3000)}};
  fill_gaps(picture);
  EXPECT_EQ(picture.texels[1].light[0], 2000);
  EXPECT_EQ(picture.texels[0], grey(1000));
}

}  // namespace
}  // namespace citykiln::impostor
