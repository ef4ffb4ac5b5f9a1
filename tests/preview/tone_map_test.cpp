#include "preview/picture/tone_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace citykiln::preview {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

Bytes toned(float r, float g, float b) {
  const float rgb[] = {r, g, b};
  return tone_map(rgb);
}

TEST(ToneMap, BlackIsZero) { EXPECT_EQ(toned(0, 0, 0), (Bytes{0, 0, 0})); }

TEST(ToneMap, GreyStaysGrey) {
  for (float v = 1e-4f; v < 100; v *= 1.1f) {
    const Bytes shown = toned(v, v, v);
    EXPECT_LE(std::ranges::max(shown) - std::ranges::min(shown), 1) << v;
  }
}

TEST(ToneMap, MoreLightIsNeverDarker) {
  const std::array<float, 3> hues[] = {{1, 1, 1}, {1, 0.2f, 0.1f}, {0.1f, 0.4f, 1}, {0.3f, 1, 0.2f}};
  for (const auto& hue : hues) {
    Bytes before{};
    for (float v = 1e-4f; v < 100; v *= 1.05f) {
      const Bytes shown = toned(v * hue[0], v * hue[1], v * hue[2]);
      for (int c = 0; c < 3; ++c) EXPECT_GE(shown[c], before[c]) << v << " channel " << c;
      before = shown;
    }
  }
}

TEST(ToneMap, MuchLightIsWhite) { EXPECT_EQ(toned(1000, 1000, 1000), (Bytes{255, 255, 255})); }

// A matt wall of reflectance 0.18 in the midday sun has the radiance 1.1; sRGB 118 is a grey of 0.18.
TEST(ToneMap, ASunlitGreyWallIsALittleAboveMiddleGrey) {
  const Bytes shown = toned(1.1f, 1.1f, 1.1f);
  EXPECT_GT(shown[0], 118);
  EXPECT_LT(shown[0], 220);
}

// White walls in the midday sun have up to 3.7, and shade a fiftieth of it.
TEST(ToneMap, NeitherWhiteWallsBurnNorShadeIsCrushed) {
  EXPECT_LT(toned(3.7f, 3.5f, 3.1f)[0], 235);
  EXPECT_GT(toned(3.7f, 3.7f, 3.7f)[0], toned(3.0f, 3.0f, 3.0f)[0] + 4);
  EXPECT_GT(toned(0.07f, 0.07f, 0.07f)[0], 12);
}

TEST(ToneMap, NotFiniteOrNegativeIsBlack) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
  for (const float v : {nan, -nan, far, -far, -1.0f}) EXPECT_EQ(toned(v, v, v), (Bytes{0, 0, 0})) << v;
}

TEST(ToneMap, OneBadChannelSpoilsNoOther) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, far, -far, -1.0f}) {
    EXPECT_EQ(toned(bad, 0.5f, 0.5f), toned(0, 0.5f, 0.5f)) << bad;
    EXPECT_EQ(toned(0.5f, 0.5f, bad), toned(0.5f, 0.5f, 0)) << bad;
  }
}

// A level between two bytes is shown by the share of pixels that have the higher one.
TEST(DitherAt, ShowsLevelsBetweenBytes) {
  constexpr int kSide = 128;
  for (const float v : {0.02f, 0.1f, 0.123f, 0.5f}) {
    const float rgb[] = {v, v, v};
    double mean = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) mean += tone_map(rgb, dither_at(x, y))[1] / double{kSide * kSide};
    const float next[] = {v * 1.002f, v * 1.002f, v * 1.002f};
    double after = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) after += tone_map(next, dither_at(x, y))[1] / double{kSide * kSide};
    EXPECT_NEAR(mean, toned(v, v, v)[1], 0.51);
    EXPECT_GT(after, mean);
  }
  const float black[] = {0, 0, 0};
  for (int x = 0; x < 1000; ++x) EXPECT_EQ(tone_map(black, dither_at(x, 7)), (Bytes{0, 0, 0}));
}

}  // namespace
}  // namespace citykiln::preview
