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

TEST(DayExposure, IsThatOfAdaptedEyesInTheLight) {
  EXPECT_EQ(day_exposure(grey(kMeanLuminance), 1), 1);
  EXPECT_EQ(day_exposure(grey(kMeanLuminance * std::exp2(-kShade_stops) * 1.01), 1), 1);
  // at dusk eyes have adapted, and the picture is as bright as by day
  EXPECT_EQ(day_exposure(grey(kMeanLuminance / 16), 16), 16);
}

TEST(DayExposure, LeavesDeepShadeTwoStopsDarkerThanLight) {
  for (const double luminance : {0.1, 0.01, 1e-4})
    EXPECT_NEAR(luminance * day_exposure(grey(luminance), 1), kMeanLuminance / 4, 1e-6);
}

TEST(DayExposure, OfABlackPictureIsThatOfAdaptedEyes) { EXPECT_EQ(day_exposure(grey(0), 1), 1); }

TEST(Exposure, FollowsTheSunDown) {
  const auto at = [](double z) { return adapted_exposure({{}, {0, 0, z}, 2.6}); };
  EXPECT_EQ(at(0.5), 1);
  EXPECT_NEAR(at(0), std::exp2(3.6), 1e-4);
  EXPECT_NEAR(at(-0.5), std::exp2(9.4), 1e-4);
  for (double z = -0.2; z < 0.4; z += 0.01) EXPECT_GE(at(z), at(z + 0.01)) << z;
}

TEST(Exposure, IsAutomaticByNightOnly) {
  const sky::Sky day{{}, {0, 0, 1}, 2.6}, night{{}, {0, 0, -1}, 2.6};
  EXPECT_EQ(exposure_under(night, grey(1e-4)), auto_exposure(grey(1e-4)));
  EXPECT_EQ(exposure_under(day, grey(1e-4)), day_exposure(grey(1e-4), 1));
  EXPECT_NE(auto_exposure(grey(1e-4)), day_exposure(grey(1e-4), 1));
}

}  // namespace
}  // namespace citykiln::preview
