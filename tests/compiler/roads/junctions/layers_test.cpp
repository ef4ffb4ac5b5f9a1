#include "compiler/roads/junctions/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "compiler/roads/roads_on_ground.h"

namespace citykiln::roads {
namespace {

using map::Passage;

map::Track track(std::int64_t id, Passage passage, int layer, Polyline axis, std::vector<std::int64_t> node_ids) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.axis = std::move(axis), t.node_ids = std::move(node_ids);
  t.surface = map::LandCoverClass::kResidentialRoad;
  t.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  t.layer = static_cast<std::int8_t>(layer), t.passage = passage;
  return t;
}

const Polyline kEastward = {{-60, 0}, {0, 0}, {60, 0}}, kNorthward = {{0, -60}, {0, 0}, {0, 60}};

std::vector<RoadLayer> layers_of(std::vector<map::Track> tracks) {
  map::Features features;
  features.tracks = std::move(tracks);
  Report report;
  std::vector<RoadLayer> layers = plan_layers(features, report);
  EXPECT_TRUE(report.balances());
  return layers;
}

TEST(RoadLayers, ABridgeOverAStreetMeetsNothing) {
  map::Features features;
  features.tracks = {track(1, Passage::kGround, 0, kEastward, {1, 2, 3}),
                     track(2, Passage::kBridge, 1, {{0, -60}, {0, 60}}, {4, 5})};
  Report report;
  EXPECT_TRUE(plan_junctions(roads_on_ground(features, report), report).empty());
  const auto layers = plan_layers(features, report);
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].roads.size(), 1u);
  EXPECT_TRUE(layers[0].junctions.empty());
}

TEST(RoadLayers, BridgesThatShareANodeMeetOnTheirLayer) {
  const auto layers = layers_of(
      {track(1, Passage::kBridge, 2, kEastward, {1, 2, 3}), track(2, Passage::kBridge, 2, {{0, 0}, {0, 60}}, {2, 5})});
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].layer, 2);
  EXPECT_EQ(layers[0].passage, Passage::kBridge);
  ASSERT_EQ(layers[0].junctions.size(), 1u);
  EXPECT_EQ(layers[0].junctions[0].nodes, (std::vector<Vec2>{{0, 0}}));
  EXPECT_EQ(layers[0].junctions[0].cuts.size(), 3u);
}

TEST(RoadLayers, ASharedNodeOverridesTheLayer) {
  // the second way connects the third with the first
  const auto layers = layers_of({track(1, Passage::kBridge, 3, kEastward, {1, 2, 3}),
                                 track(2, Passage::kBridge, 2, kNorthward, {4, 2, 5}),
                                 track(3, Passage::kBridge, 1, {{0, 60}, {0, 90}}, {5, 6})});
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].layer, 1);
  EXPECT_EQ(layers[0].roads.size(), 3u);
  EXPECT_EQ(layers[0].junctions.size(), 1u);
}

TEST(RoadLayers, OneAboveAnotherDoesNotMeetIt) {
  // at one position, but with two nodes
  const auto layers = layers_of(
      {track(1, Passage::kBridge, 1, kEastward, {1, 2, 3}), track(2, Passage::kBridge, 2, kNorthward, {4, 5, 6})});
  ASSERT_EQ(layers.size(), 2u);
  for (const RoadLayer& layer : layers) EXPECT_TRUE(layer.junctions.empty());
}

TEST(RoadLayers, ATunnelDoesNotMeetTheBridgeItRunsInto) {
  // the highest node of one is the lowest of the other, so they are neighbours in every sorted list of nodes
  const auto layers = layers_of({track(1, Passage::kBridge, 0, kEastward, {1, 2, 9}),
                                 track(2, Passage::kTunnel, 0, {{60, 0}, {60, 60}}, {9, 10}),
                                 track(3, Passage::kBridge, 0, {{0, 0}, {0, 60}}, {2, 5})});
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].layer, -1);
  EXPECT_EQ(layers[0].passage, Passage::kTunnel);
  EXPECT_TRUE(layers[0].junctions.empty());
  EXPECT_EQ(layers[1].layer, 1);
  EXPECT_EQ(layers[1].passage, Passage::kBridge);
  EXPECT_EQ(layers[1].junctions.size(), 1u);
}

TEST(RoadLayers, WithoutALayerTagBridgesAreAtOneAndTunnelsAtMinusOne) {
  const auto layers = layers_of(
      {track(1, Passage::kBridge, 0, kEastward, {1, 2, 3}), track(2, Passage::kTunnel, 0, kNorthward, {4, 5, 6})});
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].layer, -1);
  EXPECT_EQ(layers[1].layer, 1);
}

TEST(RoadLayers, AtAnAbutmentTheEndsSimplyMeet) {
  map::Features features;
  features.tracks = {track(1, Passage::kGround, 0, {{-60, 0}, {0, 0}}, {1, 2}),
                     track(2, Passage::kBridge, 1, {{0, 0}, {60, 0}}, {2, 3}),
                     track(3, Passage::kGround, 0, {{60, 0}, {120, 0}}, {3, 4})};
  Report report;
  EXPECT_TRUE(plan_junctions(roads_on_ground(features, report), report).empty());
  const auto layers = plan_layers(features, report);
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_TRUE(layers[0].junctions.empty());
}

// Random ways of any passage and layer between the nodes of a grid.
map::Features tangle(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  map::Features features;
  const auto any = [&](std::uint64_t n) { return static_cast<int>(random() % n); };
  for (int way = 1; way <= 30; ++way) {
    const int from = any(64), to = (from + 1 + any(63)) % 64;
    const auto at = [](int node) { return Vec2{node % 8 * 40.0, node / 8 * 40.0}; };
    features.tracks.push_back(
        track(way, static_cast<Passage>(any(3)), any(5) - 2, {at(from), at(to)}, {from + 1, to + 1}));
  }
  return features;
}

TEST(RoadLayers, EveryTrackIsOnTheGroundOrInOneLayer) {
  std::size_t off_ground = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const map::Features features = tangle(seed);
    Report report;
    std::multiset<ObjectId> planned;
    for (const Road& road : roads_on_ground(features, report)) planned.insert(road.id);
    for (const RoadLayer& layer : plan_layers(features, report)) {
      EXPECT_FALSE(layer.roads.empty());
      EXPECT_TRUE(std::ranges::is_sorted(layer.roads, {}, &Road::id));
      for (const Road& road : layer.roads) planned.insert(road.id), ++off_ground;
    }
    EXPECT_EQ(planned.size(), features.tracks.size());
    for (const map::Track& one : features.tracks) EXPECT_EQ(planned.count(one.id), 1u);
    EXPECT_TRUE(report.balances());
  }
  EXPECT_GT(off_ground, 0u);
}

TEST(RoadLayers, NoNodeIsInTwoLayersOfAPassage) {
  std::size_t nodes = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const map::Features features = tangle(seed);
    Report report;
    std::map<std::pair<Passage, std::int64_t>, int> layer_of;
    for (const RoadLayer& layer : plan_layers(features, report))
      for (const Road& road : layer.roads)
        for (const std::int64_t node : features.tracks[static_cast<std::size_t>(road.id.osm.id - 1)].node_ids)
          EXPECT_EQ(layer_of.try_emplace({layer.passage, node}, layer.layer).first->second, layer.layer);
    nodes += layer_of.size();
  }
  EXPECT_GT(nodes, 0u);
}

TEST(RoadLayers, AreSortedAndCountTheirNodes) {
  std::size_t all = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Report report;
    const auto layers = plan_layers(tangle(seed), report);
    const auto name = [](const RoadLayer& layer) { return std::pair(layer.layer, layer.passage); };
    // strictly: no duplicates
    EXPECT_TRUE(std::ranges::is_sorted(layers, std::ranges::less_equal{}, name));
    std::size_t junctions = 0, nodes = 0;
    for (const RoadLayer& layer : layers)
      for (const Junction& junction : layer.junctions) ++junctions, nodes += junction.nodes.size();
    const Account& account = report.account("roads", "junction_off_ground");
    EXPECT_EQ(account.out, junctions);
    EXPECT_EQ(account.in, nodes);
    all += junctions;
  }
  EXPECT_GT(all, 0u);
}

TEST(RoadLayers, NodesOfOneJunctionAreMerged) {
  map::Features features;
  features.tracks = {track(1, Passage::kBridge, 1, {{-60, 0}, {0, 0}, {5, 0}, {60, 0}}, {1, 2, 3, 4}),
                     track(2, Passage::kBridge, 1, {{0, 0}, {0, 60}}, {2, 5}),
                     track(3, Passage::kBridge, 1, {{5, 0}, {5, -60}}, {3, 6})};
  Report report;
  ASSERT_EQ(plan_layers(features, report).size(), 1u);
  const Account& account = report.account("roads", "junction_off_ground");
  EXPECT_EQ(account.in, 2u);
  EXPECT_EQ(account.merged, 1u);
  EXPECT_EQ(account.out, 1u);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::roads
