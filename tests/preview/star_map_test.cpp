#include "preview/light/star_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/sky/generate.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {
namespace {

// The sum of radiance over a cone about a direction, lx.
double illuminance_lx(const StarMap& map, Vec3 about, double pixel_rad) {
  const Frame frame = frame_about(about);
  constexpr int kSide = 400;
  const double reach = 0.012, cell = 2 * reach / kSide;
  double sum = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const Vec3 local{-reach + (i + 0.5) * cell, -reach + (j + 0.5) * cell, 1};
      sum += luminance(map.radiance(unit(frame.out_of(local)), pixel_rad)) * cell * cell;
    }
  return sum * sky::kUnitLuminance_cd_m2;
}

TEST(StarMap, HasAllLightOfAStarWhateverThePixel) {
  for (const Vec3 direction : {unit(Vec3{1, 0.0001, 0.4}), unit(Vec3{0.3, -1, 0.02}), unit(Vec3{0.001, 0.002, 1})}) {
    const StarMap map(std::vector<sky::Star>{{direction, {1e-6, 1e-6, 1e-6}}});
    for (const double pixel_rad : {0.0008, 0.002, 0.02})
      EXPECT_NEAR(illuminance_lx(map, direction, pixel_rad), 1e-6, 3e-8) << pixel_rad;
  }
}

TEST(StarMap, IsDarkBetweenStarsAndBelowTheHorizon) {
  const StarMap map(std::vector<sky::Star>{{{1, 0, 0}, {1, 1, 1}}});
  EXPECT_GT(largest_component(map.radiance(unit(Vec3{1, 0, 0.0001}), 0.001)), 0);
  EXPECT_EQ(largest_component(map.radiance(unit(Vec3{1, 0, -0.0001}), 0.001)), 0);
  EXPECT_EQ(largest_component(map.radiance(unit(Vec3{1, 0.01, 0.0001}), 0.001)), 0);
  EXPECT_EQ(largest_component(StarMap().radiance({0, 0, 1}, 0.001)), 0);
}

}  // namespace
}  // namespace citykiln::preview
