#include "preview/picture/denoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/render.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

Image town_corner(int samples, std::uint64_t seed) {
  const std::vector tiles = {
      tile({}, {floor({-60, -60, 0}, {60, 60, 0}, Material::kGrass), box({-20, -12, 0}, {-8, 4, 9}, Material::kPlaster),
                box({6, -20, 0}, {18, -8, 14}, Material::kBrick), box({-4, 6, 0}, {10, 16, 6}, Material::kPlaster)})};
  Options options;
  options.width = 96, options.height = 64, options.samples = samples, options.seed = seed, options.has_guides = true;
  const sky::Sky sky{{}, unit(Vec3{-0.5, -0.4, 0.7}), 2.6};
  return render(tiles, sky, {{20, -45, 14}, {0, 0, 3}, 45}, options);
}

double mean_squared_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double apart = a.rgb[i] - b.rgb[i], size = b.rgb[i];
    sum += apart * apart / (size * size + 0.01);
  }
  return sum / static_cast<double>(a.rgb.size());
}

TEST(Denoise, HalvesTheErrorAndMore) {
  const Image reference = town_corner(1024, 1);
  for (const int samples : {4, 16}) {
    const Image noisy = town_corner(samples, 2);
    // of little noise, details that the filter blurs are a larger share
    const double share = samples > 4 ? 0.65 : 0.5;
    EXPECT_LT(mean_squared_difference(denoise(noisy, 0), reference), share * mean_squared_difference(noisy, reference))
        << samples;
  }
}

// A picture without noise stays as it is.
TEST(Denoise, LeavesWhatHasNoError) {
  Image exact = town_corner(64, 3);
  for (float& v : exact.guides.variance) v = 0;
  const Image filtered = denoise(exact, 0);
  for (std::size_t i = 0; i < exact.rgb.size(); ++i)
    EXPECT_NEAR(filtered.rgb[i], exact.rgb[i], 0.05 * exact.rgb[i] + 1e-5) << i;
}

TEST(Denoise, AnyNumberOfThreadsIsTheSamePicture) {
  const Image noisy = town_corner(4, 4);
  EXPECT_EQ(denoise(noisy, 1).rgb, denoise(noisy, 3).rgb);
}

TEST(Denoise, LeavesStars) {
  Image night = town_corner(4, 6);
  const auto star =
      static_cast<std::size_t>(std::ranges::max_element(night.guides.depth_m) - night.guides.depth_m.begin());
  ASSERT_FALSE(std::isfinite(night.guides.depth_m[star]) && night.guides.depth_m[star] < 1e7f);
  for (int c = 0; c < 3; ++c) night.rgb[star * 3 + c] *= 50;
  const Image filtered = denoise(night, 0);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(filtered.rgb[star * 3 + c], night.rgb[star * 3 + c]);
}

TEST(Denoise, APixelThatIsNoNumberSpreadsToNoOther) {
  Image noisy = town_corner(4, 5);
  noisy.rgb[(20 * 96 + 30) * 3 + 1] = std::numeric_limits<float>::quiet_NaN();
  const Image filtered = denoise(noisy, 0);
  for (const float v : filtered.rgb) EXPECT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace citykiln::preview
