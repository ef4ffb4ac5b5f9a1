#include "compiler/verify/heights/measure_clearances.h"

#include <gtest/gtest.h>

#include "compiler/ground/profiles/crossings/crossings.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
constexpr LandCoverClass kStreet = LandCoverClass::kResidentialRoad;

roads::Road level_road(std::int64_t id, Polyline axis, double z_m, LandCoverClass surface = kStreet) {
  roads::Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.surface = surface;
  road.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  road.profile = {{0, z_m, 0}, {length_m(axis), z_m, 0}};
  road.axis = std::move(axis);
  return road;
}

structures::Span span(std::int64_t id, Polyline axis, double z_m, int layer, LandCoverClass surface = kStreet) {
  structures::Span span{level_road(id, std::move(axis), z_m, surface)};
  span.layer = static_cast<std::int8_t>(layer);
  return span;
}

const Polyline kAlong = {{100, 500}, {900, 500}}, kBesideRoad = {{500, 100}, {500, 900}};

scene::Scene scene_on_level_land(scene::Chunk chunk) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {1024, 1024}};
  chunk.heights = {{-64, -64}, {64, 64}, 19, 19, std::vector<std::int32_t>(361, 0), 0};
  scene.chunks = {std::move(chunk)};
  return scene;
}

Clearances measured(scene::Chunk chunk) { return measure_clearances(scene_on_level_land(std::move(chunk)), 1); }

TEST(MeasureClearances, FindTheShortfallOfABridgeOverARoad) {
  scene::Chunk chunk;
  chunk.roads = {level_road(1, kAlong, 10)};
  chunk.bridges = {span(2, kBesideRoad, 14, 1)};
  const Clearances c = measured(chunk);
  EXPECT_EQ(c.crossings, 1u);
  EXPECT_EQ(c.shortfalls.size(), 1u);
  EXPECT_EQ(c.count_over(1), 1u);
  EXPECT_EQ(c.count_over(3), 0u);
  EXPECT_NEAR(c.largest_m(), ground::kClearanceOverRoad_m - 4, 1e-9);
  EXPECT_EQ(c.shortfalls.front().upper, (OsmId{OsmType::kWay, 2}));
  EXPECT_EQ(c.shortfalls.front().lower, (OsmId{OsmType::kWay, 1}));
  EXPECT_EQ(c.shortfalls.front().at, (Vec2{500, 500}));
  chunk.bridges[0].profile = {{0, 16, 0}};
  EXPECT_EQ(measured(chunk).shortfalls.size(), 0u);
}

TEST(MeasureClearances, SkipBridgesAndTunnelsWithoutAProfile) {
  scene::Chunk chunk;
  chunk.roads = {level_road(1, kAlong, 300)};
  chunk.bridges = {span(2, kBesideRoad, 310, 1)};
  EXPECT_EQ(measured(chunk).crossings, 1u);
  chunk.bridges[0].profile.clear();
  EXPECT_EQ(measured(chunk).crossings, 0u);
  chunk.roads.clear(), chunk.tunnels = {span(3, kAlong, 290, -1)};
  EXPECT_EQ(measured(chunk).crossings, 0u) << "the bridge over the tunnel has no height";
}

TEST(MeasureClearances, CountContradictionsOfTheMapApart) {
  const OsmId bridge{OsmType::kWay, 2}, street{OsmType::kWay, 1}, other{OsmType::kWay, 3};
  Clearances measured{2, {{4, bridge, street, {}}, {3, bridge, other, {}}}, {}};
  const std::vector<outputs::Finding> findings = {
      {{Code::kLayersContradict, bridge, 4, {}, street}, {}, {}, {}, "w2: bridge=yes; w1: layer=1"},
      {{Code::kClearanceNotMet, bridge, 3, {}, other}, {}, {}, {}, "w2: bridge=yes; w3: no tags of height"}};
  const Clearances c = with_findings(measured, findings);
  EXPECT_EQ(c.crossings, 2u);
  ASSERT_EQ(c.shortfalls.size(), 1u);
  EXPECT_EQ(c.shortfalls[0].lower, other);
  EXPECT_EQ(c.shortfalls[0].tags, "w2: bridge=yes; w3: no tags of height");
  ASSERT_EQ(c.contradictions.size(), 1u);
  EXPECT_EQ(c.contradictions[0].lower, street);
  EXPECT_EQ(with_findings(measured, {}).shortfalls.size(), 2u);
}

TEST(MeasureClearances, TakeTheHigherLayerAsUpper) {
  scene::Chunk decks, bores, same;
  decks.bridges = {span(1, kAlong, 20, 2), span(2, kBesideRoad, 14, 0)};
  bores.tunnels = {span(1, kAlong, -14, -2), span(2, kBesideRoad, -20, -1)};
  same.bridges = {span(1, kAlong, 20, 1), span(2, kBesideRoad, 20, 0)};
  EXPECT_EQ(measured(decks).largest_m(), 0);
  EXPECT_EQ(measured(decks).crossings, 1u);
  EXPECT_NEAR(measured(bores).largest_m(), ground::kClearanceOverRoad_m + 6, 1e-9);
  EXPECT_EQ(measured(same).crossings, 0u);
}

TEST(MeasureClearances, TakeTheGroundAsAboveTunnelsAndSkipCorridors) {
  scene::Chunk chunk;
  chunk.roads = {level_road(1, kAlong, 10)};
  chunk.tunnels = {span(2, kBesideRoad, 8, -1),
                   span(3, {{600, 100}, {600, 900}}, 8, 0, LandCoverClass::kPavedFootPath)};
  const Clearances c = measured(chunk);
  EXPECT_EQ(c.crossings, 1u);
  EXPECT_NEAR(c.largest_m(), ground::kClearanceOverRoad_m - 2, 1e-9);
}

TEST(MeasureClearances, SkipLinesConnectedCloseBy) {
  scene::Chunk chunk;
  chunk.roads = {level_road(1, {{100, 500}, {500, 500}, {530, 500}}, 10)};
  chunk.bridges = {span(2, {{500, 480}, {500, 520}, {530, 500}}, 10, 1)};
  EXPECT_EQ(measured(chunk).crossings, 0u);
  chunk.bridges = {span(2, {{500, 480}, {500, 520}, {530, 501}}, 10, 1)};
  EXPECT_EQ(measured(chunk).crossings, 1u);
}

TEST(MeasureClearances, CountParallelLinesUnlessOneDescendsBesideTheOther) {
  scene::Chunk chunk;
  chunk.roads = {level_road(1, kAlong, 10)};
  chunk.bridges = {span(2, {{100, 502}, {900, 502}}, 12, 1)};
  EXPECT_EQ(measured(chunk).shortfalls.size(), 1u);
  chunk.bridges = {span(2, {{480, 502}, {520, 502}}, 12, 1)};
  chunk.roads.push_back(level_road(3, {{520, 502}, {620, 540}}, 12));
  EXPECT_EQ(measured(chunk).crossings, 0u);
}

TEST(MeasureClearances, SkipBridgesAndTunnelsSideBySide) {
  const auto crossings = [](double apart_m) {
    scene::Chunk chunk;
    const Polyline beside = {{100, 500 + apart_m}, {900, 500 + apart_m}};
    chunk.bridges = {span(1, kAlong, 20, 2), span(2, beside, 20, 1)};
    return measured(chunk).crossings;
  };
  EXPECT_EQ(crossings(4), 0u);
  EXPECT_EQ(crossings(2), 1u);
}

TEST(MeasureClearances, SkipTheApproachOfABridgeOfTheSameLayerBesideIt) {
  // the left bridge is shorter than the right one
  scene::Chunk chunk;
  chunk.bridges = {span(2, {{500, 480}, {500, 520}}, 15, 1), span(3, {{504, 300}, {504, 700}}, 15, 1)};
  chunk.roads = {level_road(4, {{500, 520}, {500, 560}}, 15)};
  EXPECT_EQ(measured(chunk).shortfalls.size(), 0u);
  chunk.bridges[0].layer = 2;
  EXPECT_EQ(measured(chunk).count_over(3), 1u);
}

TEST(MeasureClearances, CountWaterAndPathsThatFollowTheGround) {
  scene::Chunk chunk;
  chunk.bridges = {span(1, kBesideRoad, 1, 1)};
  ground::LandCoverPolygon lake{
      {{OsmType::kWay, 2}, 0}, LandCoverClass::kLake, 800, {{{400, 300}, {600, 300}, {600, 400}, {400, 400}}}};
  lake.level_m = 0;
  chunk.surfaces = {lake};
  roads::Strip stream{{{OsmType::kWay, 3}, 0}, kAlong, LandCoverClass::kRiver, 4, 4};
  stream.profile = {{0, 0.5, 0}};
  chunk.watercourses = {stream};
  chunk.roads = {level_road(4, {{100, 700}, {900, 700}}, 0, LandCoverClass::kFootPath)};
  chunk.roads[0].profile.clear();
  const Clearances c = measured(chunk);
  EXPECT_EQ(c.crossings, 3u);
  EXPECT_EQ(c.shortfalls.size(), 3u);
  EXPECT_EQ(c.count_over(1), 2u);
}

}  // namespace
}  // namespace citykiln::verify
