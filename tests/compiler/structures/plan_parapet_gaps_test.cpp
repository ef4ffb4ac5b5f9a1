#include "compiler/structures/plan_parapet_gaps.h"

#include <gtest/gtest.h>

#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

// One deck along x, another that leaves it to the left at x = 50.
std::vector<Span> fork(double other_z_m) {
  Span through = made_span({{0, 0}, {100, 0}}, {{0, 10, 0}}),
       side = made_span({{50, 0}, {50, 60}}, {{0, other_z_m, 0}});
  side.id.osm.id = 6;
  return find_parapet_gaps({through, side});
}

TEST(ParapetGaps, AreWhereEdgesLieOnTheOtherDeck) {
  const std::vector<Span> spans = fork(10);
  ASSERT_EQ(spans[0].left_gaps.size(), 1u);
  EXPECT_NEAR(spans[0].left_gaps[0].from_m, 47, 0.5);
  EXPECT_NEAR(spans[0].left_gaps[0].to_m, 53, 0.5);
  EXPECT_TRUE(spans[0].right_gaps.empty());
  ASSERT_EQ(spans[1].left_gaps.size(), 1u);
  EXPECT_EQ(spans[1].left_gaps[0].from_m, 0);
  EXPECT_NEAR(spans[1].left_gaps[0].to_m, 3, 0.5);
  EXPECT_EQ(spans[1].left_gaps, spans[1].right_gaps);
}

TEST(ParapetGaps, AreNoneOnDecksAboveOneAnother) {
  const std::vector<Span> spans = fork(16);
  ASSERT_FALSE(spans.empty());
  for (const Span& span : spans) EXPECT_TRUE(span.left_gaps.empty() && span.right_gaps.empty());
}

TEST(ParapetGaps, RemoveTheParapetAlone) {
  const std::vector<Span> spans = fork(10);
  const auto meshes = all_meshes(generate(spans[0], 0.02));
  EXPECT_TRUE(has_point(meshes, {0, 3.25, 11}));
  ASSERT_FALSE(meshes.empty());
  for (const auto& m : meshes)
    for (const auto& [a, b, c] : m.mesh.triangles) {
      const Vec3 middle = (m.mesh.positions[a] + m.mesh.positions[b] + m.mesh.positions[c]) * (1.0 / 3);
      if (middle.x > 48 && middle.x < 52 && middle.y > 0) {
        EXPECT_LE(middle.z, 10);
      }
    }
}

}  // namespace
}  // namespace citykiln::structures
