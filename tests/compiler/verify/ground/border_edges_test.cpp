#include "compiler/verify/ground/border_edges.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

TEST(BorderEdges, AreTheGroundEdgesOnTheLine) {
  bake::BakedTile tile{{0, 0}, {0, 0, 10}, 0.1, 0, {OsmId{}, {OsmType::kWay, 1}}, {}, {}};
  bake::Primitive ground;
  ground.positions = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}};
  ground.features = {1, 1, 1, 1};
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  tile.primitives = {ground};
  EXPECT_EQ(border_edges_at_x(tile, 64).ground, (std::vector<BorderEdge>{{Vec3{64, 0, 10}, Vec3{64, 64, 10}}}));
  EXPECT_EQ(border_edges_at_y(tile, 0).ground, (std::vector<BorderEdge>{{Vec3{0, 0, 10}, Vec3{64, 0, 10}}}));
  EXPECT_TRUE(border_edges_at_x(tile, 32).ground.empty());
}

TEST(BorderEdges, MatchAcrossAStepOnlyWithAVerticalFace) {
  const Vec3 a{64, 0, 10}, b{64, 1, 10}, c{64, 64, 10}, a_low{64, 0, 9}, b_low{64, 1, 9}, deeper{0, 0, 6};
  const BorderEdges high{{{a, b}, {b, c}}, {}}, low{{{a_low, b_low}, {b, c}}, {}};
  const BorderEdges stepped{high.ground, {{a_low, b_low}, {a_low, b}, {a, b}}};
  const BorderEdges skirted{high.ground, {{a - deeper, b - deeper}, {a - deeper, b}, {a, b}}};
  EXPECT_TRUE(borders_match(high, high));
  EXPECT_TRUE(borders_match(stepped, low) && borders_match(low, stepped) && borders_match(stepped, high));
  EXPECT_FALSE(borders_match(high, low) || borders_match(skirted, low) || borders_match(low, skirted));
  EXPECT_FALSE(borders_match(high, {{{a, c}}, {}}) || borders_match(high, {{{b, c}}, {}}));
}

}  // namespace
}  // namespace citykiln::verify
