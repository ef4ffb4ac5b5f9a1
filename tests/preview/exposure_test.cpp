// Exposure by the brightness of a picture.
#include "preview/picture/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::preview {
namespace {

Image grey(double luminance) {
  Image image;
  image.width = image.height = 8;
  image.rgb.assign(3 * 64, static_cast<float>(luminance));
  return image;
}

TEST(MeteredExposure, BringsAPictureByDayToItsMean) {
  EXPECT_NEAR(metered_exposure(grey(kMeanLuminance)), 1, 1e-6);
  // two stops of shade are lifted by nearly two
  EXPECT_NEAR(std::log2(metered_exposure(grey(kMeanLuminance / 4))), 1.88, 0.01);
}

TEST(MeteredExposure, LeavesNightsDarkAndSnowBright) {
  EXPECT_NEAR(std::log2(metered_exposure(grey(kMeanLuminance / 1024))), 7, 0.01);
  EXPECT_NEAR(std::log2(metered_exposure(grey(kMeanLuminance * 4))), -1, 0.01);
}

TEST(MeteredExposure, OfDarkerPicturesIsNeverLess) {
  for (double stops = -4; stops < 9; stops += 0.25)
    EXPECT_LE(metered_exposure(grey(std::exp2(-stops))), metered_exposure(grey(std::exp2(-stops - 0.25)))) << stops;
}

TEST(MeteredExposure, OfABlackPictureIsOne) { EXPECT_EQ(metered_exposure(grey(0)), 1); }

TEST(MeteredExposure, WeighsTheMiddleMost) {
  Image image = grey(0.1);
  const auto lighten = [&](int x, int y) {
    Image lighter = image;
    for (int i = 0; i < 12; ++i) lighter.rgb[static_cast<std::size_t>(((y + i / 6) * 8 + x) * 3 + i % 6)] = 0.5;
    return metered_exposure(lighter);
  };
  EXPECT_LT(lighten(3, 3), lighten(0, 0));
  EXPECT_LT(lighten(0, 0), metered_exposure(image));
}

TEST(MeteredExposure, KeepsLampsFromBurning) {
  Image night = grey(1e-3);
  for (std::size_t i = 0; i < 9; ++i) night.rgb[i] = 3;
  const double plain = metered_exposure(grey(1e-3)), lamps = metered_exposure(night);
  EXPECT_LT(lamps, plain);
  EXPECT_GE(lamps, 0.4 * plain);
}

TEST(ExposureValue, IsThatOfAHandheldMeter) {
  // "sunny 16": 1/125 s at f/16 is EV 15
  EXPECT_NEAR(exposure_value(1), 15.5, 0.1);
  EXPECT_NEAR(exposure_value(4), exposure_value(1) - 2, 1e-9);
}

TEST(WhiteBalance, HalfCorrectsTheLight) {
  const Rgb warm = {2, 1, 0.5}, gains = white_balance(warm);
  EXPECT_NEAR(gains[0] * warm[0] / (gains[1] * warm[1]), std::sqrt(2.0), 1e-9);
  for (const Rgb& white : {Rgb{1, 1, 1}, Rgb{0.01, 0.01, 0.01}})
    for (const double gain : white_balance(white)) EXPECT_NEAR(gain, 1, 1e-9);
  for (const double gain : white_balance({0, 0, 0})) EXPECT_EQ(gain, 1);
}

TEST(Exposure, FollowsTheSunDown) {
  const auto at = [](double z) { return adapted_exposure({{}, {0, 0, z}, 2.6}); };
  EXPECT_EQ(at(0.5), 1);
  EXPECT_NEAR(at(0), std::exp2(3.6), 1e-4);
  EXPECT_NEAR(at(-0.5), std::exp2(9.4), 1e-4);
  for (double z = -0.2; z < 0.4; z += 0.01) EXPECT_GE(at(z), at(z + 0.01)) << z;
}

}  // namespace
}  // namespace citykiln::preview
