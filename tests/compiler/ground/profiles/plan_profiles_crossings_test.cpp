// Profiles where ways cross: bridges, tunnels and their approaches.
#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/profiles/crossings/crossings.h"
#include "compiler/ground/profiles/crossings/enforce_clearances.h"
#include "compiler/ground/profiles/graph/approach_paths.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;
using map::Passage;

// A road, a bridge of it over x from -30 to 30, and another below along y.
map::Features crossing(Passage passage, int layer, LandCoverClass upper = kStreet, LandCoverClass lower = kStreet) {
  map::Features f;
  f.tracks = {track(1, {{-800, 0}, {-30, 0}}, upper), track(2, {{-30, 0}, {30, 0}}, upper, passage, layer),
              track(3, {{30, 0}, {800, 0}}, upper), track(4, {{0, -800}, {0, 800}}, lower)};
  return f;
}

double gap_m(const Planned& p) {
  return height_m(p.profiles.off_ground[0], 30) - height_m(p.profiles.roads.back().profile, 800);
}

TEST(Profiles, ABridgeClearsWhatItCrossesAndItsApproachesKeepTheirLimit) {
  for (const int layer : {0, 1, 5}) {
    for (const auto upper : {kStreet, LandCoverClass::kMotorwayRoad, LandCoverClass::kRailway}) {
      for (const double slope : {0.0, 0.01}) {
        const Planned p = planned(crossing(Passage::kBridge, layer, upper),
                                  field_from([&](double x, double) { return 40 + x * slope; }));
        EXPECT_GE(gap_m(p), kClearanceOverRoad_m - 0.1);
        EXPECT_LE(gap_m(p), kClearanceOverRoad_m + 0.6);
        EXPECT_EQ(p.measures.over_m, 0);
        EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 0), 40 - 800 * slope, 0.5);
        EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
      }
    }
  }
  const Planned p = planned(crossing(Passage::kBridge, 1, kStreet, LandCoverClass::kRailway),
                            field_from([](double, double) { return 40; }));
  EXPECT_GE(gap_m(p), kClearanceOverRail_m - 0.1);
}

TEST(Profiles, ARampEndsOnASlopeToo) {
  const Planned p = planned(crossing(Passage::kBridge, 1), field_from([](double x, double) { return 300 + 0.12 * x; }));
  EXPECT_GE(gap_m(p), kClearanceOverRoad_m - 0.3);
  for (const double at : {400.0, 600.0}) {
    EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 770 - at), 300 - 0.12 * (at + 30), 0.3);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, at), 300 + 0.12 * (at + 30), 0.3);
  }
}

TEST(Profiles, OnlyWhatIsLiftedAgainMayBeSteeper) {
  // a bridge on a slope so steep that its limit takes back some of the lift, far from hilly streets
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    map::Features f = street_grid(seed, 8, {-1400, -480});
    const std::size_t streets = f.tracks.size();
    for (map::Track t : crossing(Passage::kBridge, 1).tracks) {
      for (Vec2& p : t.axis) p.x += 1000;
      t.id.osm.id += 100;
      f.tracks.push_back(std::move(t));
    }
    const map::Heightfield hills = hilly_field(seed, 40, 6);
    const Planned p = planned(f, field_from([&](double x, double y) {
                                return x < 0 ? height_m_at(hills, {x, y}) : 120 + 0.17 * std::max(0.0, x - 100);
                              }));
    EXPECT_GE(height_m(p.profiles.off_ground[0], 30) - height_m(p.profiles.roads.back().profile, 800),
              kClearanceOverRoad_m - kShortfallMargin_m);
    ASSERT_GT(streets, 0u);
    for (std::size_t i = 0; i < streets; ++i) {
      const Profile& profile = p.profiles.roads[i].profile;
      const double limit = grade_rule_of(p.profiles.roads[i].surface).limit;
      for (std::size_t k = 1; k < profile.size(); ++k)
        EXPECT_LE(std::abs(profile[k].z_m - profile[k - 1].z_m),
                  limit * (profile[k].at_m - profile[k - 1].at_m) + 2 * kKnotError_m)
            << seed;
    }
  }
}

TEST(Profiles, AStreetAtHeightZeroKeepsItUnderARaisedBridge) {
  // without a profile it would lie on the bridge's embankments
  const map::Features f = crossing(Passage::kBridge, 1);
  const Planned p = planned(f, field_from([](double, double) { return 0; }));
  EXPECT_FALSE(p.profiles.roads.back().profile.empty());
  EXPECT_NEAR(height_m(p.profiles.roads.back().profile, 800), 0, 0.01);
  map::Features apart = f;
  apart.tracks.push_back(track(5, {{-800, 200}, {-100, 200}}));
  EXPECT_TRUE(planned(apart, field_from([](double, double) { return 0; })).profiles.roads.back().profile.empty());
}

TEST(Profiles, AFunicularClimbsWhereARailwayWouldCut) {
  map::Features f;
  f.tracks = {track(1, {{-300, 0}, {300, 0}}, LandCoverClass::kFunicular)};
  const map::Heightfield slope = field_from([](double x, double) { return 600 + 0.6 * x; });
  const Planned funicular = planned(f, slope);
  EXPECT_EQ(funicular.measures.over_m, 0);
  for (double at = 0; at <= 600; at += 50)
    EXPECT_NEAR(height_m(funicular.profiles.roads[0].profile, at), 600 + 0.6 * (at - 300), 2) << at;
  f.tracks[0] = track(1, {{-300, 0}, {300, 0}}, LandCoverClass::kRailway);
  EXPECT_GT(planned(f, slope).measures.over_m, 0);
}

TEST(Profiles, AFunicularNeedsTheRoomOfARailway) {
  EXPECT_EQ(wanted_clearance_m(kStreet, LandCoverClass::kFunicular), kClearanceOverRail_m);
}

TEST(Profiles, ARailwayClearsAStreetOnASlopeAsSteepAsItsLimit) {
  const Planned p = planned(crossing(Passage::kBridge, 1, LandCoverClass::kRailway),
                            field_from([](double x, double) { return 300 + 0.04 * x; }));
  EXPECT_LE(p.measures.largest_shortfall_m, kShortfallMargin_m);
}

TEST(Profiles, ABridgeThatGoesOnAsATunnelComesDownThere) {
  // the lower deck of a bridge, which goes on below the street that the upper deck goes on as
  map::Features f;
  f.tracks = {track(1, {{-400, 0}, {-100, 0}}), track(2, {{-100, 0}, {0, 0}}, kStreet, Passage::kBridge, 1),
              track(3, {{0, 0}, {100, 0}}, kStreet, Passage::kTunnel, -1), track(4, {{100, 0}, {400, 0}}),
              track(5, {{-5, 4}, {50, 4}})};
  EXPECT_EQ(planned(f, field_from([](double, double) { return 40; })).report.counts().count(Code::kClearanceNotMet),
            0u);
}

TEST(Profiles, ATunnelGoesBelowWhatItCrossesWithItsApproaches) {
  const Planned p = planned(crossing(Passage::kTunnel, 0), field_from([](double, double) { return 40; }));
  EXPECT_LE(gap_m(p), -kClearanceOverRoad_m + 0.1);
  EXPECT_NEAR(height_m(p.profiles.roads.back().profile, 800), 40, 0.01);
  EXPECT_EQ(p.measures.over_m, 0);
}

TEST(Profiles, ATunnelThatIsLoweredIsReported) {
  const Planned flat = planned(crossing(Passage::kTunnel, 0), field_from([](double, double) { return 40; }));
  const auto found = std::ranges::find(flat.report.diagnoses(), Code::kTunnelLowered, &Diagnosis::code);
  ASSERT_NE(found, flat.report.diagnoses().end());
  EXPECT_EQ(found->object, (OsmId{OsmType::kWay, 2}));
  EXPECT_NEAR(found->size, kClearanceOverRoad_m, 0.5);
  const Planned bridge = planned(crossing(Passage::kBridge, 1), field_from([](double, double) { return 40; }));
  EXPECT_EQ(bridge.report.counts().count(Code::kTunnelLowered), 0u);
}

TEST(Profiles, ALongTunnelGoesDownFromItsMouths) {
  map::Features f = crossing(Passage::kTunnel, -1);
  f.tracks[0] = track(1, {{-800, 0}, {-300, 0}});
  f.tracks[1] = track(2, {{-300, 0}, {300, 0}}, kStreet, Passage::kTunnel, -1);
  f.tracks[2] = track(3, {{300, 0}, {800, 0}});
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_NEAR(height_m(p.profiles.off_ground[0], 300), 33, 0.5);
  EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 500), 34.5, 0.2);
  EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 400), 40, 0.1);
}

TEST(Profiles, ABridgeThatCrossesNothingIsNoHump) {
  for (const int layer : {-2, 0, 1, 5}) {
    map::Features f = crossing(Passage::kBridge, layer);
    f.tracks.pop_back();
    const Planned p = planned(f, field_from([](double, double) { return 40; }));
    ASSERT_FALSE(p.profiles.off_ground[0].empty());
    for (const Knot& k : p.profiles.off_ground[0]) EXPECT_EQ(k.z_m, 40);
  }
}

TEST(Profiles, AShortTunnelWithoutALayerIsNoPit) {
  map::Features f = crossing(Passage::kTunnel, 0);
  f.tracks.pop_back();
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_GT(height_m(p.profiles.off_ground[0], 30), 40 - kTunnelCover_m);
  ASSERT_FALSE(p.profiles.roads.empty());
  for (const roads::Road& road : p.profiles.roads) {
    EXPECT_FALSE(road.profile.empty());
    for (const Knot& k : road.profile) EXPECT_EQ(k.z_m, 40);
  }
}

TEST(Profiles, ALayerWithoutABridgeIsGround) {
  const Planned p = planned(crossing(Passage::kGround, 3), field_from([](double, double) { return 40; }));
  ASSERT_FALSE(p.profiles.roads.empty());
  for (const roads::Road& road : p.profiles.roads) {
    EXPECT_FALSE(road.profile.empty());
    for (const Knot& k : road.profile) EXPECT_EQ(k.z_m, 40);
  }
}

TEST(Profiles, ABridgeRunsStraightOverAValley) {
  map::Features f = crossing(Passage::kBridge, 1);
  f.tracks[0] = track(1, {{-800, 0}, {-200, 0}});
  f.tracks[1] = track(2, {{-200, 0}, {200, 0}}, kStreet, Passage::kBridge, 1);
  f.tracks[2] = track(3, {{200, 0}, {800, 0}});
  const Planned p = planned(f, field_from([](double x, double) { return std::abs(x) >= 192 ? 100 + x / 40 : 40; }));
  for (double at = 0; at <= 400; at += 8)
    EXPECT_NEAR(height_m(p.profiles.off_ground[0], at), 100 + (at - 200) / 40, 2.0) << at;
}

TEST(Profiles, AStackClearsStoreyByStorey) {
  map::Features f;
  f.tracks = {track(1, {{-800, 0}, {800, 0}})};
  const Vec2 directions[] = {{0, 1}, {0.6, 0.8}, {-0.6, 0.8}};
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](double run_m) {
      return Vec2{std::floor(directions[k].x * run_m * 128) / 128, std::floor(directions[k].y * run_m * 128) / 128};
    };
    f.tracks.push_back(track(10 * k + 10, {at(-800), at(-150)}));
    f.tracks.push_back(track(10 * k + 11, {at(-150), at(150)}, kStreet, Passage::kBridge, k + 1));
    f.tracks.push_back(track(10 * k + 12, {at(150), at(800)}));
  }
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  for (int k = 0; k < 3; ++k)
    EXPECT_GE(height_m(p.profiles.off_ground[static_cast<std::size_t>(k)], 150),
              40 + kClearanceOverRoad_m * (k + 1) - 0.2);
  EXPECT_LT(p.measures.largest_shortfall_m, kShortfallMargin_m);
  EXPECT_EQ(p.measures.over_m, 0);
}

TEST(Profiles, AnUnderpassBetweenStepsGoesDownAndLeavesTheRailwayLevel) {
  map::Features f;
  f.tracks = {track(1, {{0, -800}, {0, 800}}, LandCoverClass::kRailway),
              track(2, {{-9, 0}, {9, 0}}, LandCoverClass::kPedestrianStreet, Passage::kTunnel, -1),
              track(3, {{-30, 0}, {-9, 0}}, LandCoverClass::kSteps),
              track(4, {{9, 0}, {30, 0}}, LandCoverClass::kSteps)};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
  EXPECT_LT(height_m(p.profiles.off_ground[0], 9), 40 - kClearanceOverPath_m);
  const auto railway = std::ranges::find(p.profiles.roads, ObjectId{{OsmType::kWay, 1}}, &roads::Road::id);
  ASSERT_NE(railway, p.profiles.roads.end());
  for (const Knot& k : railway->profile) EXPECT_EQ(k.z_m, 40);
}

TEST(Profiles, ReportAClearanceThatIsNotMet) {
  // the bridge ends on paths too long to rise with it
  map::Features f = crossing(Passage::kBridge, 1, LandCoverClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-kLongestApproach_m - 30, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {kLongestApproach_m + 30, 0}}, kFootway);
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  const auto found = std::ranges::find(p.report.diagnoses(), Code::kClearanceNotMet, &Diagnosis::code);
  ASSERT_NE(found, p.report.diagnoses().end());
  EXPECT_EQ(found->object, (OsmId{OsmType::kWay, 2}));
  EXPECT_EQ(found->other, (OsmId{OsmType::kWay, 4}));
  EXPECT_EQ(p.report.counts().at(Code::kClearanceNotMet), 1u);
  EXPECT_EQ(p.measures.shortfalls, 1u);
  EXPECT_NEAR(p.measures.largest_shortfall_m, kClearanceOverRoad_m - 0.06 * 30 - kMaxGroundMove_m, 0.5);
}

TEST(Profiles, ReportLayersThatContradictEachOther) {
  // the same, with a street that has the bridge's layer
  map::Features f = crossing(Passage::kBridge, 1, LandCoverClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-kLongestApproach_m - 30, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {kLongestApproach_m + 30, 0}}, kFootway);
  f.tracks[3].layer = 1;
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
  EXPECT_EQ(p.report.counts().at(Code::kLayersContradict), 1u);
  EXPECT_EQ(p.measures.shortfalls, 0u);
  EXPECT_EQ(p.measures.contradictions, 1u);
}

TEST(Profiles, LayersContradictUnlessTheySayTheOrder) {
  const auto of = [](Passage passage, int layer) { return track(1, {{0, 0}, {9, 0}}, kStreet, passage, layer); };
  const map::Track ground = of(Passage::kGround, 0), bridge = of(Passage::kBridge, 0), tunnel = of(Passage::kTunnel, 0);
  EXPECT_FALSE(layers_contradict(bridge, ground));
  EXPECT_FALSE(layers_contradict(ground, tunnel));
  EXPECT_FALSE(layers_contradict(of(Passage::kBridge, 2), of(Passage::kBridge, 1)));
  EXPECT_FALSE(layers_contradict(of(Passage::kTunnel, -1), of(Passage::kTunnel, -2)));
  EXPECT_TRUE(layers_contradict(bridge, of(Passage::kBridge, -1)));
  EXPECT_TRUE(layers_contradict(tunnel, of(Passage::kTunnel, -2)));
  EXPECT_TRUE(layers_contradict(bridge, of(Passage::kGround, 1)));
  EXPECT_TRUE(layers_contradict(of(Passage::kGround, -1), tunnel));
}

TEST(Profiles, ReportBridgesThatCrossWithoutAnOrder) {
  map::Features f;
  f.tracks = {track(1, {{-30, 0}, {30, 0}}, kStreet, Passage::kBridge, 1),
              track(2, {{0, -30}, {0, 30}}, kStreet, Passage::kBridge, 1)};
  const auto unordered = [](const map::Features& features) {
    const Planned p = planned(features, field_from([](double, double) { return 40; }));
    const auto found = std::ranges::find(p.report.diagnoses(), Code::kCrossingWithoutOrder, &Diagnosis::code);
    return found == p.report.diagnoses().end() ? OsmId{} : found->other;
  };
  EXPECT_EQ(unordered(f), (OsmId{OsmType::kWay, 2}));
  f.tracks[1].layer = 2;
  EXPECT_EQ(unordered(f), OsmId{});
  // with a common node they meet
  f.tracks = {track(1, {{-30, 0}, {0, 0}, {30, 0}}, kStreet, Passage::kBridge, 1),
              track(2, {{0, -30}, {0, 0}, {0, 30}}, kStreet, Passage::kBridge, 1)};
  EXPECT_EQ(unordered(f), OsmId{});
}

TEST(Profiles, AFootwayInATunnelRisesOverATunnelThatCannotFall) {
  // the lower tunnel leaves the street 52 m before, the footway begins at the same street
  map::Features f;
  f.tracks = {track(1, {{0, -600}, {0, -300}}),
              track(2, {{0, -300}, {0, 0}, {0, 12}, {0, 300}}, kStreet, Passage::kTunnel, -1),
              track(3, {{0, 300}, {0, 600}}),
              track(4, {{0, 12}, {40, 12}, {40, -40}}, LandCoverClass::kMotorwayRoad, Passage::kTunnel, -2),
              track(5, {{0, 0}, {80, 0}}, kFootway, Passage::kTunnel, -1)};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.crossings, 1u);
  EXPECT_LE(p.measures.largest_shortfall_m, kShortfallMargin_m);
}

TEST(Profiles, ABridgesEndThatMeetsNothingMayRise) {
  map::Features f = crossing(Passage::kBridge, 1, LandCoverClass::kMotorwayRoad);
  f.tracks.erase(f.tracks.begin());
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.report.counts().at(Code::kBridgeWithoutGround), 1u);
  EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
  EXPECT_GT(p.profiles.off_ground[0].front().z_m, 43);
}

// A footway along x, `passage` from -10 to 10, steps of 16 m and long paths beyond; a street along y.
map::Features footbridge(Passage passage, int layer) {
  map::Features f;
  f.tracks = {track(1, {{-1500, 0}, {-26, 0}}, kFootway),
              track(2, {{-26, 0}, {-10, 0}}, LandCoverClass::kSteps),
              track(3, {{-10, 0}, {10, 0}}, kFootway, passage, layer),
              track(4, {{10, 0}, {26, 0}}, LandCoverClass::kSteps),
              track(5, {{26, 0}, {1500, 0}}, kFootway),
              track(6, {{0, -300}, {0, 300}})};
  return f;
}

TEST(Profiles, StepsClimbToTheirFootbridgeAndGoDownToTheirUnderpass) {
  for (const auto& [passage, layer] : {std::pair(Passage::kBridge, 1), std::pair(Passage::kTunnel, -1)}) {
    const Planned p = planned(footbridge(passage, layer), field_from([](double, double) { return 40; }));
    EXPECT_EQ(p.measures.crossings, 1u);
    EXPECT_LE(p.measures.largest_shortfall_m, kShortfallMargin_m);
    const double rise_m = height_m(p.profiles.off_ground[0], 0) - 40;
    EXPECT_GT(rise_m * layer, 1.5);
    // the street stays, the steps join the deck and the ground
    ASSERT_FALSE(p.profiles.roads[4].profile.empty());
    for (const Knot& k : p.profiles.roads[4].profile) EXPECT_EQ(k.z_m, 40);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, 16), 40 + rise_m, kKnotError_m);
    EXPECT_NEAR(height_m(p.profiles.roads[1].profile, 0), 40, 0.5);
    EXPECT_TRUE(p.profiles.roads[0].profile.empty());
  }
}

TEST(Profiles, FootbridgesAndUnderpassesAreReportedAsTheyAreWritten) {
  const Planned bridge = planned(footbridge(Passage::kBridge, 1), field_from([](double, double) { return 40; }));
  EXPECT_EQ(bridge.report.counts().count(Code::kTooSteep), 0u);
  const Planned tunnel = planned(footbridge(Passage::kTunnel, -1), field_from([](double, double) { return 40; }));
  EXPECT_EQ(tunnel.report.counts()[Code::kTunnelLowered], 1u);
  const auto found = std::ranges::find(tunnel.report.diagnoses(), Code::kTunnelLowered, &Diagnosis::code);
  ASSERT_NE(found, tunnel.report.diagnoses().end());
  EXPECT_EQ(found->object, (OsmId{OsmType::kWay, 3}));
  double lowest_m = 40;
  for (const Knot& knot : tunnel.profiles.off_ground[0]) lowest_m = std::min(lowest_m, knot.z_m);
  EXPECT_NEAR(found->size, 40 - lowest_m, kKnotError_m + 0.01);
}

TEST(Profiles, APathOverATunnelIsNotInTheCuttingOfItsMouth) {
  map::Features f;
  f.tracks = {track(1, {{0, -600}, {0, -150}}), track(2, {{0, -150}, {0, 150}}, kStreet, Passage::kTunnel, -1),
              track(3, {{0, 150}, {0, 600}}), track(4, {{-100, -145}, {100, -145}}, kFootway)};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.crossings, 1u);
  EXPECT_LE(p.measures.largest_shortfall_m, kShortfallMargin_m);
}

TEST(Profiles, APathThatPassesBelowABridgeKeepsItsHeight) {
  // without a profile it would lie on the embankments beside it
  map::Features f = footbridge(Passage::kBridge, 1);
  f.tracks[5] = track(6, {{0, -300}, {0, 300}}, kFootway);
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  ASSERT_FALSE(p.profiles.roads[4].profile.empty());
  for (const Knot& k : p.profiles.roads[4].profile) EXPECT_EQ(k.z_m, 40);
}

TEST(Profiles, AFootbridgeGoesStraightFromCrestToCrest) {
  map::Features f;
  f.tracks = {track(1, {{-90, 0}, {-60, 0}}, LandCoverClass::kSteps),
              track(2, {{-60, 0}, {60, 0}}, kFootway, Passage::kBridge, 1),
              track(3, {{60, 0}, {90, 0}}, LandCoverClass::kSteps), track(4, {{-40, -300}, {-40, 300}}),
              track(5, {{40, -300}, {40, 300}})};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.shortfalls, 0u);
  for (double at = 20; at <= 100; at += 4) EXPECT_GT(height_m(p.profiles.off_ground[0], at), 44.7) << at;
}

TEST(Profiles, PathsThatNeedNotClimbKeepNone) {
  map::Features f = footbridge(Passage::kBridge, 1);
  f.tracks.pop_back();
  const Planned p = planned(f, hilly_field(3, 40, 4));
  ASSERT_FALSE(p.profiles.roads.empty());
  for (const roads::Road& road : p.profiles.roads) EXPECT_TRUE(road.profile.empty());
}

TEST(Profiles, APathGoesDownUnderABridgeThatCannotRise) {
  map::Features f = crossing(Passage::kBridge, 1, LandCoverClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-kLongestApproach_m - 30, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {kLongestApproach_m + 30, 0}}, kFootway);
  f.tracks[3] = track(4, {{0, -100}, {0, 100}}, kFootway);
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.shortfalls, 0u);
  EXPECT_LT(height_m(p.profiles.roads[2].profile, 100), 39);
  EXPECT_NEAR(height_m(p.profiles.roads[2].profile, 0), 40, kKnotError_m);
}

TEST(Profiles, ATunnelGoesDownUnderABridgeThatCannotRise) {
  map::Features f = crossing(Passage::kBridge, 1, LandCoverClass::kMotorwayRoad);
  f.tracks[0] = track(1, {{-kLongestApproach_m - 30, 0}, {-30, 0}}, kFootway);
  f.tracks[2] = track(3, {{30, 0}, {kLongestApproach_m + 30, 0}}, kFootway);
  f.tracks[3] = track(4, {{0, -800}, {0, -30}});
  f.tracks.push_back(track(5, {{0, -30}, {0, 30}}, kStreet, Passage::kTunnel, -1));
  f.tracks.push_back(track(6, {{0, 30}, {0, 800}}));
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.measures.shortfalls, 0u);
}

TEST(Profiles, WhatComesDownBesideALineDoesNotPassOverIt) {
  // a bridge that ends on its own street, a lane's width beside another
  map::Features f;
  f.tracks = {track(1, {{-300, 4}, {-30, 4}}), track(2, {{-30, 4}, {30, 4}}, kStreet, Passage::kBridge, 1),
              track(3, {{30, 4}, {300, 4}}), track(4, {{20, 0}, {300, 0}})};
  EXPECT_EQ(planned(f, field_from([](double, double) { return 40; })).measures.crossings, 0u);
  // along its whole length it crosses
  f.tracks[3] = track(4, {{-300, 0}, {300, 0}});
  f.tracks[1] = track(2, {{-30, 4}, {-10, 40}, {10, 40}, {30, 4}}, kStreet, Passage::kBridge, 1);
  f.tracks.push_back(track(5, {{-300, 38}, {300, 38}}));
  EXPECT_GE(planned(f, field_from([](double, double) { return 40; })).measures.crossings, 1u);
}

TEST(Profiles, OfTwoBridgesSideBySideNoneIsAbove) {
  // carriageways of one bridge with different layers, which overlap by an assumed width
  const auto crossings = [](double apart_m) {
    map::Features f;
    for (const double y : {0.0, apart_m}) {
      const auto id = static_cast<std::int64_t>(f.tracks.size());
      f.tracks.push_back(track(id + 1, {{-600, y}, {-300, y}}));
      f.tracks.push_back(track(id + 2, {{-300, y}, {300, y}}, kStreet, Passage::kBridge, y > 0 ? 1 : 2));
      f.tracks.push_back(track(id + 3, {{300, y}, {600, y}}));
    }
    return planned(f, field_from([](double, double) { return 40; })).measures.crossings;
  };
  EXPECT_EQ(crossings(4), 0u);
  EXPECT_GE(crossings(2), 1u);
}

TEST(Profiles, NoRoadRisesWithAFootbridgeThatEndsOnIt) {
  // from a path over a street up to a road, 20 m beside it
  map::Features f;
  f.tracks = {track(1, {{-400, 0}, {0, 0}, {400, 0}}), track(2, {{-400, 16}, {400, 16}}),
              track(3, {{0, 0}, {0, 20}}, kFootway, Passage::kBridge, 1), track(4, {{0, 20}, {0, 200}}, kFootway)};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_NEAR(height_m(p.profiles.roads[0].profile, 400), 40, 0.1);
  EXPECT_EQ(p.report.counts().count(Code::kClearanceNotMet), 0u);
}

TEST(Profiles, APavementsBridgeIsNotAboveTheApproachOfTheRoadBesideIt) {
  // over a motorway: a road whose bridge is shorter than that of its pavement, which lies within the road's width
  map::Features f;
  f.tracks = {track(1, {{-400, -40}, {-60, -40}, {-30, 0}, {-20, 0}}),
              track(2, {{-20, 0}, {20, 0}}, kStreet, Passage::kBridge, 1),
              track(3, {{20, 0}, {30, 0}, {60, -40}, {400, -40}}),
              track(4, {{-400, 4}, {-36, 4}}, kFootway),
              track(5, {{-36, 4}, {36, 4}}, kFootway, Passage::kBridge, 1),
              track(6, {{36, 4}, {400, 4}}, kFootway),
              track(7, {{0, -400}, {0, 400}}, LandCoverClass::kMotorwayRoad)};
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  double highest_m = 0;
  for (const Knot& knot : p.profiles.off_ground[1]) highest_m = std::max(highest_m, knot.z_m);
  EXPECT_NEAR(highest_m, 40 + kClearanceOverRoad_m - kThinDeck_m, 0.6);
}

TEST(Profiles, AFootbridgeComesDownOnItsPaths) {
  map::Features f;
  f.tracks = {track(1, {{-100, 0}, {-40, 0}}, LandCoverClass::kPavedFootPath),
              track(2, {{-40, 0}, {40, 0}}, LandCoverClass::kPavedFootPath, Passage::kBridge, 1),
              track(3, {{40, 0}, {100, 0}}, LandCoverClass::kPavedFootPath), track(4, {{0, -300}, {0, 300}})};
  const map::Heightfield heights = field_from([](double x, double) { return 40 + x / 50; });
  const Planned p = planned(f, heights);
  EXPECT_NEAR(p.profiles.off_ground[0].front().z_m, height_m_at(heights, {-40, 0}), kProfileQuantum_m);
  EXPECT_NEAR(p.profiles.off_ground[0].back().z_m, height_m_at(heights, {40, 0}), kProfileQuantum_m);
  EXPECT_GE(height_m(p.profiles.off_ground[0], 40) - height_m(p.profiles.roads[2].profile, 300),
            kClearanceOverRoad_m - kThinDeck_m - 0.1);
}

// A bridge over a street ends where a tunnel begins, each with a map node of its own there.
TEST(Profiles, WaysOffTheGroundMeetWhereTheyEndAtOnePlace) {
  map::Features f;
  f.tracks = {track(1, {{-300, 0}, {-30, 0}}), track(2, {{-30, 0}, {30, 0}}, kStreet, Passage::kBridge, 1),
              track(3, {{30, 0}, {90, 0}}, kStreet, Passage::kTunnel, -1), track(4, {{90, 0}, {300, 0}}),
              track(5, {{0, -300}, {0, 300}})};
  f.tracks[2].node_ids.front() = 7;
  const Planned p = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(p.profiles.off_ground[0].back().z_m, p.profiles.off_ground[1].front().z_m);
  // and one on the ground
  f.tracks[3].node_ids.front() = 8;
  const Planned q = planned(f, field_from([](double, double) { return 40; }));
  EXPECT_EQ(q.profiles.off_ground[1].back().z_m, height_m(q.profiles.roads[1].profile, 0));
}

TEST(Profiles, BridgesClearStandingWater) {
  map::Features f = crossing(Passage::kBridge, 1);
  f.tracks.pop_back();
  LandCoverPolygon lake{
      {{OsmType::kWay, 99}, 0}, LandCoverClass::kLake, 800, {{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}}};
  lake.level_m = 39.5;
  Report report;
  const auto roads = roads::roads_on_ground(f, report);
  const map::Heightfield heights = field_from([](double, double) { return 40; });
  const Profiles p = plan_profiles(f, roads, {}, {}, std::span(&lake, 1), heights, report);
  EXPECT_GE(height_m(p.off_ground[0], 30), 39.5 + kClearanceOverWater_m - 0.05);
}

TEST(Profiles, AFootbridgeClearsAPondBetweenItsStations) {
  map::Features f;
  f.tracks = {track(1, {{-60, 0}, {-6, 0}}, kFootway), track(2, {{-6, 0}, {6, 0}}, kFootway, Passage::kBridge, 1),
              track(3, {{6, 0}, {60, 0}}, kFootway)};
  LandCoverPolygon pond{
      {{OsmType::kWay, 99}, 0}, LandCoverClass::kLake, 9, {{{-3, -1.5}, {3, -1.5}, {3, 1.5}, {-3, 1.5}}}};
  pond.level_m = 39.5;
  Report report;
  const auto roads = roads::roads_on_ground(f, report);
  const map::Heightfield heights = field_from([](double, double) { return 40; });
  const Profiles p = plan_profiles(f, roads, {}, {}, std::span(&pond, 1), heights, report);
  ASSERT_EQ(p.shortfalls.size(), 1u);
  EXPECT_EQ(p.shortfalls[0].lower, pond.id.osm);
  EXPECT_GE(height_m(p.off_ground[0], 6), 39.5 + kClearanceOverWater_m - kShortfallMargin_m);
}

}  // namespace
}  // namespace citykiln::ground
