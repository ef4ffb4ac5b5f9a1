#include "compiler/structures/tunnel.h"

#include <gtest/gtest.h>

#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/profiles/planned_spans.h"
#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

map::Heightfield level_square_of_512_m(double z_m) {
  map::Heightfield field{{-256, -256}, {256, 256}, 3, 3, {}, 0};
  field.heights.assign(9, static_cast<std::int32_t>(z_m / map::kHeightQuantum_m));
  return field;
}

Span tunnel() {
  Span span = made_span({{0, 0}, {60, 0}, {100, 30}}, {{0, 10, 0}, {110, 12, 0}}, true);
  span.from = {EndKind::kGround, {-20, 0}, 0}, span.to = {EndKind::kJoint, {140, 60}, 0};
  span.is_bored = true;
  return span;
}

TEST(Tunnel, IsUndergroundOnlyBelowTheTerrain) {
  EXPECT_TRUE(is_underground(tunnel(), level_square_of_512_m(30)));
  EXPECT_FALSE(is_underground(tunnel(), level_square_of_512_m(14)));
  EXPECT_FALSE(is_underground(tunnel(), level_square_of_512_m(0)));
}

TEST(Tunnel, APathThatEntersOnLevelGroundGoesDownInsideAndRaisesNoMound) {
  Span path = made_span({{0, 0}, {100, 0}}, {{0, 20, 0}, {30, 10, 0}, {100, 10, 0}});
  path.surface = map::LandCoverClass::kPavedFootPath;
  path.from = {EndKind::kGround, {-20, 0}, 0};
  EXPECT_TRUE(ground::enters_from_above(path, level_square_of_512_m(20)));
  EXPECT_FALSE(is_underground(path, level_square_of_512_m(20)));
  // a path that has come down before the tunnel
  path.profile = {{0, 10, 0}, {100, 10, 0}};
  EXPECT_TRUE(is_underground(path, level_square_of_512_m(20)));
  // roads dig ramps
  path.surface = map::LandCoverClass::kPrimaryRoad;
  path.profile = {{0, 20, 0}, {30, 10, 0}, {100, 10, 0}};
  EXPECT_TRUE(is_underground(path, level_square_of_512_m(20)));
}

TEST(Tunnel, HasNoMeshUnlessBored) {
  Span span = tunnel();
  span.is_bored = false;
  EXPECT_TRUE(all_meshes(generate_tunnel(span, 0.1)).empty());
}

TEST(Tunnel, FacesInwards) {
  Span span = tunnel();
  span.from = span.to = {};
  const auto meshes = all_meshes(generate_tunnel(span, 0.1));
  EXPECT_TRUE(open_edges(meshes).empty());
  EXPECT_NEAR(volume_m3(meshes), -110 * (10 * 5.0 + 6 * 0.125), 60);
}

TEST(Tunnel, IsOpenAtPortalsAndJoints) {
  // open edges lie in the planes of the two ends
  const auto open = open_edges(all_meshes(generate_tunnel(tunnel(), 0.1)));
  EXPECT_FALSE(open.empty());
  for (const auto& [edge, times] : open) {
    const bool at_mouth = edge.first.x == 0 && edge.second.x == 0;
    const Vec2 along = unit(Vec2{40, 30});
    const bool at_joint = std::abs(dot(in_plan(edge.first) - Vec2{100, 30}, along)) < 0.01 &&
                          std::abs(dot(in_plan(edge.second) - Vec2{100, 30}, along)) < 0.01;
    EXPECT_TRUE(at_mouth || at_joint) << edge.first.x << " " << edge.second.x;
  }
}

TEST(Tunnel, HasItsCeilingAtTheBoreHeightOfTheGround) {
  const auto meshes = all_meshes(generate_tunnel(tunnel(), 0.1));
  EXPECT_TRUE(has_point(meshes, {0, 5, 10 + ground::bore_height_m(tunnel())}));
}

}  // namespace
}  // namespace citykiln::structures
