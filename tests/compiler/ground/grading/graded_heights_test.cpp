#include "compiler/ground/grading/graded_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "tests/compiler/ground/grading/made_graded_terrain.h"

namespace citykiln::ground {
namespace {

TEST(GradedHeights, CachedHeightsEqualFreshOnes) {
  const GradedTerrain graded = road_over_hills({{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3});
  ASSERT_TRUE(has_grading(graded, {{-16, -16}, {16, 16}}));
  GradedHeights heights(graded);
  const RandomSequence draw(1, StableId{36}, "places");
  for (std::uint32_t i = 0; i < 3000; ++i) {
    // few places, on both sides of both axes, so that most occur again
    const Vec2 p{std::floor(draw.between(-16, 16, 3 * i)), std::floor(draw.between(-16, 16, 3 * i + 1)) / 1024};
    EXPECT_EQ(draw.below(2, 3 * i + 2) == 0 ? heights.at(p).heights : heights.uncached_at(p), heights_at(graded, p));
    EXPECT_EQ(heights.at(p).terrain_m, map::height_m_at(graded.terrain, p));
  }
}

}  // namespace
}  // namespace citykiln::ground
