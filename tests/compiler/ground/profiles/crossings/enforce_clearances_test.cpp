// Heights at crossings after clearances are enforced.
#include "compiler/ground/profiles/crossings/enforce_clearances.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/profiles/crossings/clearances.h"
#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/lowering_caps.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;
using map::Passage;

// A network on level ground at 40 m, and its crossings.
struct CrossingNetwork {
  map::Features features;
  std::vector<roads::Road> roads;
  std::vector<roads::Junction> junctions;
  ProfileGraph graph;
  std::vector<Crossing> crossings;
  std::vector<double> level_m;
};

CrossingNetwork crossing_network(std::vector<map::Track> tracks) {
  CrossingNetwork m;
  Report report;
  m.features.tracks = std::move(tracks);
  m.roads = roads::roads_on_ground(m.features, report);
  m.junctions = roads::plan_junctions(m.roads, report);
  m.graph = graph_of(m.features, m.roads, m.junctions);
  m.crossings = find_crossings(m.graph, m.features, {{}, {}, [](Vec2) { return 40.0; }});
  m.level_m.assign(m.graph.nodes.size(), 40);
  return m;
}

double largest_shortfall_m(const CrossingNetwork& m, std::span<const double> z_m) {
  double largest_m = -1;
  for (const Crossing& c : m.crossings) largest_m = std::max(largest_m, clearance_shortfall_m(m.graph, c, z_m));
  return largest_m;
}

// The steepest leg as a share of its limit.
double steepest(const CrossingNetwork& m, std::span<const double> z_m) {
  double most = 0;
  for (std::uint32_t n = 0; n < m.graph.nodes.size(); ++n)
    for (const Leg& leg : m.graph.legs_of(n))
      most = std::max(most, std::abs(z_m[leg.to] - z_m[n]) / (limit_of(m.graph, leg) * leg.length_m));
  return most;
}

std::vector<map::Track> bridge_over_a_street(LandCoverClass surface) {
  return {track(1, {{-800, 0}, {-30, 0}}, surface), track(2, {{-30, 0}, {30, 0}}, surface, Passage::kBridge, 1),
          track(3, {{30, 0}, {800, 0}}, surface), track(4, {{0, -800}, {0, 800}})};
}

TEST(EnforceClearances, BridgesOfAllClassesRiseWithinTheirLimits) {
  for (const auto surface : {kStreet, LandCoverClass::kMotorwayRoad, LandCoverClass::kRailway}) {
    const CrossingNetwork m = crossing_network(bridge_over_a_street(surface));
    ASSERT_FALSE(m.crossings.empty());
    const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, m.level_m);
    EXPECT_LE(largest_shortfall_m(m, z_m), 0.011);
    EXPECT_LE(steepest(m, z_m), 1 + 1e-9);
  }
}

TEST(EnforceClearances, AStackRisesAsAWhole) {
  std::vector<map::Track> tracks = bridge_over_a_street(kStreet);
  tracks.push_back(track(5, {{-500, -500}, {-60, -60}}));
  tracks.push_back(track(6, {{-60, -60}, {60, 60}}, kStreet, Passage::kBridge, 2));
  tracks.push_back(track(7, {{60, 60}, {500, 500}}));
  const CrossingNetwork m = crossing_network(std::move(tracks));
  const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, m.level_m);
  EXPECT_LE(largest_shortfall_m(m, z_m), 0.011);
}

TEST(EnforceClearances, TheNodesOfAJunctionMoveByTheSame) {
  std::vector<map::Track> tracks = bridge_over_a_street(kStreet);
  tracks.push_back(track(5, {{-45, -300}, {-45, 0}, {-45, 300}}));
  tracks[0] = track(1, {{-800, 0}, {-45, 0}, {-30, 0}});
  const CrossingNetwork m = crossing_network(std::move(tracks));
  const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, m.level_m);
  double highest_m = 0;
  for (std::uint32_t a = 0; a < m.graph.nodes.size(); ++a) {
    if (m.graph.nodes[a].junction == kNone) continue;
    highest_m = std::max(highest_m, z_m[a]);
    for (std::uint32_t b = 0; b < a; ++b)
      if (m.graph.nodes[b].junction == m.graph.nodes[a].junction) {
        EXPECT_EQ(z_m[a], z_m[b]);
      }
  }
  EXPECT_GT(highest_m, 41);
  EXPECT_LE(steepest(m, z_m), 1 + kRampFade + 1e-9);
}

TEST(EnforceClearances, AStreetRisesOverATunnelThatIsTiedToABridge) {
  // a bridge over a lake goes on as a tunnel below a street: the lower deck of a street on two levels
  CrossingNetwork m =
      crossing_network({track(1, {{-800, 0}, {-100, 0}}), track(2, {{-100, 0}, {0, 0}}, kStreet, Passage::kBridge, 1),
                        track(3, {{0, 0}, {60, 0}}, kStreet, Passage::kTunnel, -1), track(4, {{60, 0}, {800, 0}}),
                        track(5, {{30, -800}, {30, 800}})});
  std::uint32_t bridge = 0;
  while (m.graph.ways[bridge].track->id.osm.id != 2) ++bridge;
  m.crossings.push_back({.upper = bridge, .upper_at_m = 98, .lower_z_m = 38, .wanted_m = kClearanceOverWater_m});
  const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, m.level_m);
  EXPECT_LE(largest_shortfall_m(m, z_m), 0.011);
  EXPECT_LE(steepest(m, z_m), 1 + kRampFade + 1e-9);
}

// The deepest that lines of a class on the ground lie below the level.
double deepest_on_ground_m(const CrossingNetwork& m, std::span<const double> z_m, LandCoverClass surface) {
  double deepest_m = 0;
  for (const GraphWay& way : m.graph.ways)
    if (way.track->surface == surface && way.track->passage == Passage::kGround)
      for (const Station& s : m.graph.stations_of(way)) deepest_m = std::max(deepest_m, 40 - z_m[s.node]);
  return deepest_m;
}

TEST(EnforceClearances, NoStreetIsLoweredWithTheRampOfAGarage) {
  // two storeys below a street, reached from the same street by a short ramp
  constexpr auto kRamp = LandCoverClass::kServiceRoad;
  const CrossingNetwork m =
      crossing_network({track(1, {{-300, 0}, {0, 0}, {300, 0}}), track(2, {{0, 0}, {0, 20}}, kRamp),
                        track(3, {{0, 20}, {10, 30}, {20, 20}, {20, -30}}, kRamp, Passage::kTunnel, -2),
                        track(4, {{-300, 12}, {300, 12}}, LandCoverClass::kTram, Passage::kTunnel, -1)});
  ASSERT_GE(m.crossings.size(), 2u);
  const std::vector<double> cleared_m = clear_crossings(m.graph, m.crossings, nullptr, m.level_m);
  for (const auto& z_m : {cleared_m, enforce_clearances(m.graph, m.crossings, m.level_m, cleared_m)}) {
    EXPECT_LE(deepest_on_ground_m(m, z_m, kStreet), kMaxCuttingForAccess_m + 1e-9);
    EXPECT_LE(deepest_on_ground_m(m, z_m, kRamp), kMaxCutting_m + 1e-9);
  }
}

TEST(EnforceClearances, NoCuttingIsDeeperThanItsLimit) {
  // four tunnels below each other, with the mouths of the lowest close by
  std::vector<map::Track> tracks{track(1, {{-400, 0}, {-25, 0}}),
                                 track(2, {{-25, 0}, {25, 0}}, kStreet, Passage::kTunnel, -4),
                                 track(3, {{25, 0}, {400, 0}})};
  for (int k = 1; k <= 3; ++k) {
    const Vec2 end{100.0 * (k - 2), 300};
    tracks.push_back(track(3 + k, {Vec2{} - end, end}, kStreet, Passage::kTunnel, -k));
  }
  const CrossingNetwork m = crossing_network(std::move(tracks));
  const std::vector<double> cleared_m = clear_crossings(m.graph, m.crossings, nullptr, m.level_m);
  const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, cleared_m);
  EXPECT_LE(deepest_on_ground_m(m, z_m, kStreet), kMaxCutting_m + 1e-9);
  EXPECT_GT(deepest_on_ground_m(m, z_m, kStreet), 4);
}

TEST(EnforceClearances, ADrivewayIsNoSteeperWhereItsStreetCannotBeLowered) {
  // a driveway that ends a little beyond its junction, below a bridge that comes down on footpaths on both sides; the
  // street already lies as low as it may
  constexpr auto kPath = LandCoverClass::kFootPath, kDeck = LandCoverClass::kPedestrianStreet;
  constexpr auto kDriveway = LandCoverClass::kServiceRoad;
  const CrossingNetwork m =
      crossing_network({track(1, {{0, -300}, {0, 0}, {0, 300}}), track(2, {{0, 0}, {8, 0}}, kDriveway),
                        track(3, {{7.5, -10}, {7.5, 10}}, kDeck, Passage::kBridge, 1),
                        track(4, {{7.5, 10}, {7.5, 60}}, kPath), track(5, {{7.5, -60}, {7.5, -10}}, kPath)});
  std::vector<double> low_m = m.level_m;
  for (std::uint32_t n = 0; n < low_m.size(); ++n)
    if (m.graph.nodes[n].is_on_ground && !m.graph.nodes[n].is_pinned) low_m[n] -= kMaxCuttingForAccess_m;
  ASSERT_GT(largest_shortfall_m(m, low_m), 1);
  const std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, low_m);
  EXPECT_GT(deepest_on_ground_m(m, z_m, kDriveway), kMaxCuttingForAccess_m + 0.1);
  EXPECT_LE(steepest(m, z_m), 1 + 1e-9);
}

TEST(EnforceClearances, NothingMovesThatIsClear) {
  const CrossingNetwork m = crossing_network(bridge_over_a_street(kStreet));
  std::vector<double> z_m = enforce_clearances(m.graph, m.crossings, m.level_m, m.level_m);
  for (double& z : z_m) z = std::ceil(z * 64) / 64;
  const std::vector<Crossing> none;
  EXPECT_EQ(enforce_clearances(m.graph, none, z_m, z_m), z_m);
}

}  // namespace
}  // namespace citykiln::ground
