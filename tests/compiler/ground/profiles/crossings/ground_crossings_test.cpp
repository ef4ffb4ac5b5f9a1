#include "compiler/ground/profiles/crossings/ground_crossings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

// Two ways that cross at the origin without a common node.
map::Features crossing_ways(map::LandCoverClass along, map::LandCoverClass across) {
  map::Features f;
  f.tracks = {track(1, {{-300, 0}, {300, 0}}, along), track(2, {{-40, -300}, {40, 300}}, across)};
  return f;
}

// Land whose slope changes at the origin, so that each class smooths it in its own way.
map::Heightfield ridge() {
  return field_from([](double x, double y) { return 100 - 0.25 * std::abs(x + 0.6 * y); }, 2048, 16);
}

double step_m(const map::Features& features, const Planned& p) {
  const double second_m = length_m(features.tracks[1].axis) / 2;
  return std::abs(height_m(p.profiles.roads[0].profile, 300) - height_m(p.profiles.roads[1].profile, second_m));
}

TEST(GroundCrossings, AStepThatStaysNamesBothWays) {
  // a railway does not meet the road
  map::Features features = crossing_ways(map::LandCoverClass::kRailway, map::LandCoverClass::kFarmTrack);
  features.tracks[0].is_rail = true;
  const Planned p = planned(features, ridge());
  const double step = step_m(features, p);
  ASSERT_GT(step, kSmallStep_m);
  const auto found = std::ranges::find(p.report.diagnoses(), Code::kStepAtCrossing, &Diagnosis::code);
  ASSERT_NE(found, p.report.diagnoses().end());
  EXPECT_EQ(found->object, features.tracks[0].id.osm);
  EXPECT_EQ(found->other, features.tracks[1].id.osm);
  EXPECT_NEAR(found->size, step, 0.1);
  EXPECT_EQ(p.report.counts().at(Code::kStepAtCrossing), 1u);
}

TEST(GroundCrossings, BridgesAndTunnelsDoNotMeetTheGround) {
  const map::Track road = track(1, {{-300, 0}, {300, 0}});
  map::Track other = track(2, {{0, -300}, {0, 300}});
  other.passage = map::Passage::kBridge;
  map::Features features;
  features.tracks = {road, other};
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  EXPECT_TRUE(ground_crossings(graph_of(features, roads, {}).ways).empty());
}

TEST(GroundCrossings, WaysThatShareANodeDoNotCrossThere) {
  map::Features features;
  features.tracks = {track(1, {{-300, 0}, {0, 0}, {300, 0}}), track(2, {{0, -300}, {0, 0}, {0, 300}})};
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  EXPECT_TRUE(ground_crossings(graph_of(features, roads, {}).ways).empty());
}

}  // namespace
}  // namespace citykiln::ground
