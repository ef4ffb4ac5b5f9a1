#include "compiler/verify/heights/measure_lakes.h"

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

// A riverbank relation of two outlines: one has no waterway and is level, the other follows its waterway.
TEST(MeasureLakes, LeavesOutPartsOfARiverThatRun) {
  scene::Chunk chunk;
  const Ring dock = {{80, 0}, {96, 0}, {96, 16}, {80, 16}}, river = {{0, 0}, {64, 0}, {64, 64}, {0, 64}};
  chunk.surfaces = {{{kGroundFeature, 0}, map::LandCoverClass::kRiver, 4096, {river}},
                    {{kGroundFeature, 1}, map::LandCoverClass::kRiver, 256, {dock}, 0, 12.0}};
  const auto lakes_at = [&](std::array<float, 4> corners_m) {
    return measure_lakes(chunk, index_ground(made_ground(map::LandCoverClass::kRiver, corners_m)));
  };
  EXPECT_EQ(lakes_at({0, 0, 0.5F, 0}).not_level, 0u);
  chunk.surfaces[1].rings = {river}, chunk.surfaces[0].rings = {dock};
  EXPECT_EQ(lakes_at({2, 2, 2, 2}).waters, 1u);
  EXPECT_EQ(lakes_at({2, 2, 2, 2}).not_level, 0u);
  EXPECT_EQ(lakes_at({2, 2, 2.5F, 2}).largest_m, 0.5);
}

}  // namespace
}  // namespace citykiln::verify
