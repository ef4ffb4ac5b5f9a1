#include "compiler/verify/heights/explain_earthworks.h"

#include <gtest/gtest.h>

#include <functional>

namespace citykiln::verify {
namespace {

constexpr OsmId kRoad{OsmType::kWay, 1};
constexpr Vec2 kMiddle{512, 512};

// A tile of 1,024 m with samples every 16 m, and a level road at 100 m through its middle.
scene::Scene scene_with(const std::function<double(Vec2)>& terrain_m) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {1024, 1024}};
  scene.header.tile_m = 1024;
  scene::Chunk& chunk = scene.chunks.emplace_back();
  chunk.heights = {.min = {0, 0}, .step_m = {16, 16}, .columns = 65, .rows = 65, .heights = {}};
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      chunk.heights.heights.push_back(
          static_cast<std::int32_t>(terrain_m(chunk.heights.vertex(i, j)) / map::kHeightQuantum_m));
  roads::Road road;
  road.id = {kRoad, 0};
  road.axis = {{0, 512}, {1024, 512}};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.profile = {{0, 100, 0}};
  chunk.roads = {road};
  return scene;
}

double block_of_spikes(Vec2 p) {
  return std::abs(p.x - kMiddle.x) <= 32 && std::abs(p.y - kMiddle.y) <= 16 ? 200 : 100;
}

std::vector<DeepEarthwork> deep_of(const scene::Scene& scene, std::span<const outputs::Finding> findings = {}) {
  return explain_earthworks(scene, measure_earthworks(scene), findings);
}

TEST(ExplainEarthworks, ACutThroughABlockOfSpikesStandsAlone) {
  const auto deep = deep_of(scene_with(block_of_spikes));
  ASSERT_EQ(deep.size(), 1u);
  EXPECT_EQ(deep[0].earthwork.depth_m, 100);
  EXPECT_EQ(deep[0].reason, EarthworkReason::kStandsAlone);
}

TEST(ExplainEarthworks, AFillOverAHoleStandsAlone) {
  const auto deep = deep_of(scene_with([](Vec2 p) { return 200 - block_of_spikes(p); }));
  ASSERT_EQ(deep.size(), 1u);
  EXPECT_EQ(deep[0].earthwork.depth_m, -100);
  EXPECT_EQ(deep[0].reason, EarthworkReason::kStandsAlone);
}

TEST(ExplainEarthworks, WithinItsLimitACutIsNotListed) {
  EXPECT_TRUE(deep_of(scene_with([](Vec2 p) { return block_of_spikes(p) > 100 ? 111 : 100; })).empty());
}

TEST(ExplainEarthworks, ASlopeARidgeAndAValleyDoNotStandAlone) {
  const std::function<double(Vec2)> lands[] = {
      [](Vec2 p) { return 120 + (p.y - kMiddle.y); },                      // the road is drawn beside its terrace
      [](Vec2 p) { return std::abs(p.x - kMiddle.x) <= 32 ? 150 : 100; },  // a tunnel without its tag
      [](Vec2 p) { return std::abs(p.x - kMiddle.x) <= 32 ? 50 : 100; }};  // a bridge without its tag
  for (const auto& land : lands) {
    const auto deep = deep_of(scene_with(land));
    ASSERT_FALSE(deep.empty());
    for (const DeepEarthwork& each : deep) EXPECT_EQ(each.reason, EarthworkReason::kNone);
  }
}

TEST(ExplainEarthworks, AFindingAboutTheHeightsOfTheLineExplainsThem) {
  const scene::Scene scene = scene_with(block_of_spikes);
  const std::vector<outputs::Finding> steep = {{{Code::kTooSteep, kRoad, 0.3}, std::nullopt, {}}};
  EXPECT_EQ(deep_of(scene, steep)[0].reason, EarthworkReason::kFinding);
  const std::vector<outputs::Finding> narrow = {{{Code::kRoadNarrowed, kRoad, 1}, std::nullopt, {}}};
  EXPECT_EQ(deep_of(scene, narrow)[0].reason, EarthworkReason::kStandsAlone);
}

TEST(ExplainEarthworks, ALandformAndAMouthOfATunnelExplainThem) {
  scene::Scene scene = scene_with(block_of_spikes);
  const Vec2 at = measure_earthworks(scene)[0].at;
  structures::Span tunnel;
  tunnel.axis = {at + Vec2{0, 50}, at + Vec2{0, 300}};
  scene.chunks[0].tunnels = {tunnel};
  EXPECT_EQ(deep_of(scene)[0].reason, EarthworkReason::kMouth);
  ground::Landform pier;
  pier.axis = {at + Vec2{-8, 20}, at + Vec2{8, 20}};
  pier.surface = map::LandCoverClass::kPier, pier.left_m = pier.right_m = 1;
  pier.profile = {{0, 90, 0}};
  pier.kind = ground::LandformKind::kDeck;
  scene.chunks[0].landforms = {pier};
  EXPECT_EQ(deep_of(scene)[0].reason, EarthworkReason::kLandform);
}

}  // namespace
}  // namespace citykiln::verify
