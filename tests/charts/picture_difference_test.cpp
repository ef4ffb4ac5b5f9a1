#include "tests/charts/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace citykiln::charts {
namespace {

preview::Image grey(std::vector<float> pixels) {
  preview::Image image{.width = static_cast<int>(pixels.size()), .height = 1};
  for (const float pixel : pixels) image.rgb.insert(image.rgb.end(), {pixel, pixel, pixel});
  return image;
}

TEST(LuminanceDifference, IsNoneOfEqualPictures) {
  const LuminanceDifference none = luminance_difference(grey({0.25f, 2}), grey({0.25f, 2}));
  EXPECT_NEAR(none.ratio, 1, 1e-12);
  EXPECT_NEAR(none.rms, 0, 1e-12);
}

TEST(LuminanceDifference, HasMeanAndRootMeanSquareAsSharesOfTheReference) {
  const LuminanceDifference there = luminance_difference(grey({3, 2}), grey({1, 1}));
  EXPECT_NEAR(there.ratio, 2.5, 1e-6);
  EXPECT_NEAR(there.rms, std::sqrt((4.0 + 1) / 2), 1e-6);
}

TEST(LuminanceDifference, WeighsChannelsAsTheEyeDoes) {
  preview::Image green = grey({1}), blue = grey({1});
  green.rgb = {0, 1, 0}, blue.rgb = {0, 0, 1};
  EXPECT_NEAR(luminance_difference(green, grey({1})).ratio, 0.7152, 1e-6);
  EXPECT_NEAR(luminance_difference(blue, grey({1})).ratio, 0.0722, 1e-6);
}

}  // namespace
}  // namespace citykiln::charts
