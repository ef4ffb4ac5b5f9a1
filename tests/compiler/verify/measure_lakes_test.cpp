#include "compiler/verify/measure_lakes.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

Lakes lakes_of(double level_m, std::array<float, 4> corners_m) {
  scene::Chunk chunk;
  const Ring shore = {{0, 0}, {64, 0}, {64, 64}, {0, 64}};
  chunk.surfaces = {{{kGroundFeature, 0}, map::LandCoverClass::kLake, 4096, {shore}, 0, level_m}};
  return measure_lakes(chunk, index_ground(made_ground(map::LandCoverClass::kLake, corners_m)));
}

TEST(MeasureLakes, ReportsNoErrorOnLevelWater) {
  const Lakes lakes = lakes_of(10, {0, 0, 0, 0});
  EXPECT_EQ(lakes.waters, 1u);
  EXPECT_EQ(lakes.not_level, 0u);
}

TEST(MeasureLakes, FindsACornerOffTheLevel) {
  const Lakes lakes = lakes_of(10, {0, 0, 0.5F, 0});
  EXPECT_EQ(lakes.not_level, 1u);
  EXPECT_EQ(lakes.largest_m, 0.5);
  EXPECT_EQ(lakes.worst, kGroundFeature);
}

TEST(MeasureLakes, FindsWaterAtAnotherLevel) { EXPECT_EQ(lakes_of(11, {0, 0, 0, 0}).largest_m, 1); }

}  // namespace
}  // namespace citykiln::verify
