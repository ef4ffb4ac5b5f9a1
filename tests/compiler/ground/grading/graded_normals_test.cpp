#include "compiler/ground/grading/graded_normals.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"
#include "tests/compiler/ground/grading/made_graded_terrain.h"

namespace citykiln::ground {
namespace {

TEST(GradedNormals, CachedNormalsEqualFreshOnes) {
  const GradedTerrain graded = road_over_hills({{{map::LaneKind::kSidewalk, map::LaneDirection::kBoth, 2, 0, true},
                                                 {map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}},
                                                3});
  ASSERT_TRUE(has_grading(graded, {{-16, -16}, {16, 16}}));
  GradedNormals normals(graded);
  const RandomSequence draw(1, StableId{35}, "places");
  for (std::uint32_t i = 0; i < 3000; ++i) {
    // few places, so that most occur again, on another layer or the same
    const Vec2 p{std::floor(draw.between(-16, 16, 3 * i)), std::floor(draw.between(-16, 16, 3 * i + 1))};
    const auto layer = static_cast<HeightLayer>(draw.below(4, 3 * i + 2));
    EXPECT_EQ(normals.at(grid_point(p), layer), normals_at(graded, p)[static_cast<std::size_t>(layer)]);
  }
}

}  // namespace
}  // namespace citykiln::ground
