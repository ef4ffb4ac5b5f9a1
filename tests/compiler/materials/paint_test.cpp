#include "compiler/materials/paint.h"

#include <gtest/gtest.h>

#include "compiler/materials/material.h"

namespace citykiln::materials {
namespace {

constexpr TextureImage::Texel kBlack = {0, 0, 0}, kGrey = {75, 75, 77}, kWhite = {255, 255, 255}, kRed = {200, 0, 0};

TextureImage::Texel at(const TextureImage& image, std::size_t column, std::size_t row) {
  return image.texels[row * image.columns + column];
}

TEST(Paint, MixesInLinearLight) {
  TextureImage image = blank_image(1, 1, 1, kBlack);
  paint(image, {0, 1}, {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, kWhite);
  // half of the light of white is sRGB 188
  EXPECT_EQ(at(image, 0, 0), (TextureImage::Texel{188, 188, 188}));
}

TEST(Paint, PaintsThinLinesFaintly) {
  TextureImage image = blank_image(1, 4, 1, kGrey);
  paint(image, {0, 4}, {{1.4, 0}, {1.45, 0}, {1.45, 1}, {1.4, 1}}, kWhite);
  EXPECT_GT(at(image, 1, 0)[0], kGrey[0]);
  EXPECT_LT(at(image, 1, 0)[0], 130);
}

TEST(Paint, PaintsLaterOverEarlier) {
  const Ring all = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  TextureImage image = blank_image(1, 2, 2, kBlack);
  paint(image, {0, 2}, all, kWhite);
  paint(image, {0, 2}, all, kRed);
  EXPECT_EQ(image.texels, std::vector(4, kRed));
}

TEST(Paint, StopsAtItsColumns) {
  TextureImage image = blank_image(1, 6, 2, kGrey);
  paint(image, {2, 4}, {{-1, 0}, {9, 0}, {9, 2}, {-1, 2}}, kWhite);
  for (std::size_t column = 0; column < 6; ++column)
    EXPECT_EQ(at(image, column, 1), column == 2 || column == 3 ? kWhite : kGrey) << column;
}

TEST(Paint, ClipsAtTheImagesEdge) {
  TextureImage image = blank_image(1, 2, 2, kGrey);
  paint(image, {0, 9}, {{1, 0}, {9, 0}, {9, 1}, {1, 1}}, kWhite);
  EXPECT_EQ(at(image, 0, 0), kGrey);
  EXPECT_EQ(at(image, 1, 0), kWhite);
}

TEST(Paint, WrapsAroundAlongV) {
  TextureImage over = blank_image(0.5, 4, 24, kGrey), under = over;
  paint(over, {0, 4}, {{0.2, 11.3}, {1.7, 11.6}, {1.1, 13.1}}, kWhite);
  paint(under, {0, 4}, {{0.2, -0.7}, {1.7, -0.4}, {1.1, 1.1}}, kWhite);
  EXPECT_EQ(over, under);
  EXPECT_NE(at(over, 2, 0), kGrey);
  EXPECT_NE(at(over, 2, 23), kGrey);
}

TEST(Material, SrgbOfLinearIsTheInverseOfLinearOfSrgb) {
  for (int value = 0; value < 256; ++value)
    EXPECT_EQ(srgb_of_linear(linear_of_srgb(static_cast<std::uint8_t>(value))), value);
  EXPECT_EQ(srgb_of_linear(-1), 0);
  EXPECT_EQ(srgb_of_linear(2), 255);
  // 0.2140 is the linear value of 127 and a half
  EXPECT_EQ(srgb_of_linear(0.2139), 127);
  EXPECT_EQ(srgb_of_linear(0.2160), 128);
}

}  // namespace
}  // namespace citykiln::materials
