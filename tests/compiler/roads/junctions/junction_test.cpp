#include "compiler/roads/junctions/junction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/geometry/snap.h"
#include "compiler/roads/junctions/corner_pavements.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/junctions/random_roads.h"
#include "tests/compiler/roads/made_road.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

Road road_of_width(std::int64_t id, Polyline axis, double width_m = 6,
                   LandCoverClass surface = LandCoverClass::kResidentialRoad) {
  return made_road(id, std::move(axis), width_m, surface);
}

struct Outlined {
  std::vector<Junction> junctions;
  std::vector<std::vector<Polygon>> outlines;
  Report report;
};

Outlined outlined(const std::vector<Road>& roads) {
  Outlined all;
  all.junctions = plan_junctions(roads, all.report);
  all.outlines = outline_junctions(all.junctions, roads, 1);
  return all;
}

class Junctions : public testing::Test {
 protected:
  // Checks the guarantees of every case, whatever else it tests.
  Outlined sound(const std::vector<Road>& roads) {
    Outlined all = outlined(roads);
    const Faults faults = faults_of(all.junctions, all.outlines, roads);
    EXPECT_EQ(faults.self_crossing, 0);
    EXPECT_EQ(faults.spikes, 0);
    EXPECT_EQ(faults.beyond_reach, 0);
    EXPECT_LT(faults.overlap_m2, 0.01);
    return all;
  }

  Geos geos_;
};

TEST_F(Junctions, ARoadThatEndsAloneHasNone) {
  EXPECT_TRUE(sound({road_of_width(1, {{0, 0}, {50, 0}})}).junctions.empty());
}

TEST_F(Junctions, ARoadThatGoesOnUnderAnotherNameHasNone) {
  EXPECT_TRUE(sound({road_of_width(1, {{0, 0}, {50, 0}}), road_of_width(2, {{50, 0}, {100, 5}})}).junctions.empty());
}

TEST_F(Junctions, TwoWidthsMeetInOne) {
  const Outlined all = sound({road_of_width(1, {{0, 0}, {50, 0}}, 6), road_of_width(2, {{50, 0}, {100, 5}}, 10)});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts.size(), 2u);
  EXPECT_EQ(all.outlines[0].size(), 1u);
}

TEST_F(Junctions, ACrossingIsCutSquareBehindItsRoundedCorners) {
  const Outlined all =
      sound({road_of_width(1, {{-50, 0}, {0, 0}, {50, 0}}), road_of_width(2, {{0, -50}, {0, 0}, {0, 50}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  // half the other road and the kerb radius
  for (const Cut& cut : all.junctions[0].cuts) EXPECT_EQ(cut, (Cut{8, 5}));
  // a cross with arms 6 m wide and 16 m long, and four corners with a radius of 5 m
  EXPECT_NEAR(area_m2(all.outlines[0][0]), 2 * 16 * 6 - 36 + 4 * 25 * (1 - std::numbers::pi / 4), 0.6);
}

TEST_F(Junctions, ARampLeavesItsMotorwayWithinReach) {
  const Outlined all = sound({road_of_width(1, {{-80, 0}, {0, 0}, {80, 0}}, 11, LandCoverClass::kMotorwayRoad),
                              road_of_width(2, {{0, 0}, {40, 4}, {80, 14}}, 5, LandCoverClass::kMotorwayRoad)});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_LE(std::ranges::max(all.junctions[0].cuts, {}, &Cut::length_m).length_m, kJunctionRadius_m);
}

TEST_F(Junctions, ArmsSideBySideAreCutAtTheReach) {
  const Outlined all = sound({road_of_width(1, {{0, 0}, {100, 0}}), road_of_width(2, {{0, 0}, {100, 0.5}}),
                              road_of_width(3, {{0, 0}, {-100, 0}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(std::ranges::max(all.junctions[0].cuts, {}, &Cut::length_m).length_m, kJunctionRadius_m);
}

TEST_F(Junctions, AnArmShorterThanItsCutIsSwallowed) {
  const Outlined all = sound({road_of_width(1, {{-50, 0}, {0, 0}, {50, 0}}), road_of_width(2, {{0, 0}, {0, 2}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.report.counts()[Code::kRoadInsideJunctions], 1u);
}

TEST_F(Junctions, ALoopAtOneNodeHasTwoArmsThere) {
  const Outlined all =
      sound({road_of_width(1, {{0, 0}, {30, 10}, {40, 0}, {30, -10}, {0, 0}}), road_of_width(2, {{0, 0}, {-50, 0}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts.size(), 3u);
}

TEST_F(Junctions, OfTwoRoadsThatShareBothEndsAreTwo) {
  const Outlined all =
      sound({road_of_width(1, {{0, 0}, {25, 8}, {50, 0}}), road_of_width(2, {{0, 0}, {25, -8}, {50, 0}}),
             road_of_width(3, {{-40, 0}, {0, 0}}), road_of_width(4, {{50, 0}, {90, 0}})});
  EXPECT_EQ(all.junctions.size(), 2u);
}

TEST_F(Junctions, ADogLegIsOneJunction) {
  const Outlined all = sound({road_of_width(1, {{-50, 0}, {0, 0}, {5, 0}, {50, 0}}),
                              road_of_width(2, {{0, 0}, {0, 50}}), road_of_width(3, {{5, 0}, {5, -50}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].nodes.size(), 2u);
  EXPECT_EQ(all.report.counts()[Code::kJunctionsMerged], 1u);
}

Road oneway(std::int64_t id, Polyline axis, double width_m = 7) {
  Road made = road_of_width(id, std::move(axis), width_m);
  made.section.lanes.front().way = map::LaneDirection::kForward;
  return made;
}

TEST_F(Junctions, ADualCarriagewayCrossedIsOneJunction) {
  const Outlined all = sound({oneway(1, {{-80, 0}, {0, 0}, {80, 0}}), oneway(2, {{80, 16}, {0, 16}, {-80, 16}}),
                              road_of_width(3, {{0, -60}, {0, 0}, {0, 16}, {0, 70}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].nodes.size(), 2u);
  // arms side by side are cut at the street's kerbs, not at the intersection far out
  for (const Cut& cut : all.junctions[0].cuts) EXPECT_TRUE(cut.length_m == kWholeLink_m || cut.length_m < 10);
}

TEST_F(Junctions, ADualCarriagewayThatEndsOnAStreetDoesSoAtOne) {
  const Outlined all = sound({oneway(1, {{0, 0}, {80, 0}}), oneway(2, {{80, 14}, {0, 14}}),
                              road_of_width(3, {{0, -60}, {0, 0}, {0, 14}, {0, 70}})});
  EXPECT_EQ(all.junctions.size(), 1u);
}

TEST_F(Junctions, PavementsGoRoundCornersThatBothArmsHaveThem) {
  const std::vector<Road> roads = {made_road(1, {{-50, 0}, {0, 0}, {50, 0}}, 6, LandCoverClass::kResidentialRoad, 2, 0),
                                   made_road(2, {{0, 0}, {0, 50}}, 6, LandCoverClass::kResidentialRoad, 0, 2)};
  const Outlined all = sound(roads);
  ASSERT_EQ(all.junctions.size(), 1u);
  const auto arms = arms_of(all.junctions, roads);
  const std::vector<Ring> rings = stroke_corner_pavements(all.junctions[0], roads, arms[0]);
  ASSERT_EQ(rings.size(), 1u);
  // about the centre (8, 8) of the kerb: the kerb at 5 m, the pavement's edge at 3 m
  const Polygon corner{rings[0], {}};
  const Vec2 inward = unit(Vec2{-1, -1});
  EXPECT_TRUE(contains(corner, Vec2{8, 8} + inward * 3.1));
  EXPECT_FALSE(contains(corner, Vec2{8, 8} + inward * 2.9));
  const std::vector<Ring> kerbs = stroke_corner_kerbs(all.junctions[0], roads, arms[0], 0.15625);
  ASSERT_EQ(kerbs.size(), 1u);
  const Polygon kerb{kerbs[0], {}};
  EXPECT_TRUE(contains(kerb, Vec2{8, 8} + inward * 4.9));
  EXPECT_FALSE(contains(kerb, Vec2{8, 8} + inward * 4.8));
}

TEST_F(Junctions, VergesWithoutAPavementGoRoundNoCorner) {
  std::vector<Road> roads = {made_road(1, {{-50, 0}, {0, 0}, {50, 0}}, 6, LandCoverClass::kResidentialRoad, 2, 0),
                             made_road(2, {{0, 0}, {0, 50}}, 6, LandCoverClass::kResidentialRoad, 0, 2)};
  roads[1].section.lanes.back().kind = map::LaneKind::kVerge;
  const Outlined all = sound(roads);
  EXPECT_TRUE(stroke_corner_pavements(all.junctions[0], roads, arms_of(all.junctions, roads)[0]).empty());
  EXPECT_TRUE(stroke_corner_kerbs(all.junctions[0], roads, arms_of(all.junctions, roads)[0], 0.15625).empty());
}

TEST_F(Junctions, TwoStreetsACarsLengthApartAreTwo) {
  const auto streets = [&](double apart_m) {
    return sound({road_of_width(1, {{-80, 0}, {0, 0}, {apart_m, 0}, {80, 0}}), road_of_width(2, {{0, 0}, {0, 50}}),
                  road_of_width(3, {{apart_m, 0}, {apart_m, -50}})})
        .junctions.size();
  };
  EXPECT_EQ(streets(10), 1u);
  EXPECT_EQ(streets(12), 2u);
}

TEST_F(Junctions, ADrivewayNearACornerIsNotPartOfIt) {
  const Outlined all =
      sound({road_of_width(1, {{-80, 0}, {0, 0}, {8, 0}, {80, 0}}), road_of_width(2, {{0, 0}, {0, 50}}),
             road_of_width(3, {{8, 0}, {8, -50}}, 3, LandCoverClass::kServiceRoad)});
  EXPECT_EQ(all.junctions.size(), 2u);
}

TEST_F(Junctions, AnIslandBetweenTwoOnewaysIsInsideOne) {
  const Outlined all = sound({road_of_width(1, {{-80, 0}, {0, 0}}, 7), road_of_width(2, {{20, 0}, {90, 0}}, 7),
                              oneway(3, {{0, 0}, {10, -6}, {20, 0}}, 4), oneway(4, {{20, 0}, {10, 6}, {0, 0}}, 4)});
  ASSERT_EQ(all.junctions.size(), 1u);
  ASSERT_EQ(all.outlines[0].size(), 1u);
  EXPECT_EQ(all.outlines[0][0].holes.size(), 1u);
}

TEST_F(Junctions, BentArmsHaveRoundedCorners) {
  // like a street that leaves a roundabout: 30 degrees within its first 6 m, then away
  const Outlined all =
      sound({road_of_width(1, {{-60, 0}, {0, 0}, {60, 0}}), road_of_width(2, {{0, 0}, {5, 3}, {8, 8}, {8, 60}}, 5)});
  ASSERT_EQ(all.junctions.size(), 1u);
  const auto& cuts = all.junctions[0].cuts;
  EXPECT_EQ(std::ranges::count_if(cuts, [](const Cut& cut) { return cut.radius_m >= 2; }), 2);
}

TEST_F(Junctions, WidthsTaperOneInFive) {
  const std::vector<Road> roads = {road_of_width(1, {{-60, 0}, {0, 0}}, 10), road_of_width(2, {{0, 0}, {60, 0}}, 6)};
  const Outlined all = sound(roads);
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts, (std::vector<Cut>{{1, 0}, {10, 0}}));
  EXPECT_NEAR(area_m2(all.outlines[0][0]), 10 * 1 + 10 * (10 + 6) / 2, 1e-6);
}

TEST_F(Junctions, StairsAndPathsStepFromWidthToWidth) {
  const Outlined all = sound({road_of_width(1, {{-60, 0}, {0, 0}}, 40, LandCoverClass::kSteps),
                              road_of_width(2, {{0, 0}, {60, 0}}, 2, LandCoverClass::kPavedFootPath)});
  ASSERT_EQ(all.junctions.size(), 1u);
  for (const Cut& cut : all.junctions[0].cuts) EXPECT_LE(cut.length_m, 1);
}

TEST_F(Junctions, ATaperIsNoLongerThanHalfItsLink) {
  const Outlined all = sound({road_of_width(1, {{-60, 0}, {0, 0}}, 10), road_of_width(2, {{0, 0}, {12, 0}}, 6),
                              road_of_width(3, {{12, 0}, {60, 0}}, 10)});
  ASSERT_EQ(all.junctions.size(), 2u);
  EXPECT_EQ(all.junctions[0].cuts[1].length_m, 6);
  EXPECT_EQ(all.report.counts()[Code::kRoadInsideJunctions], 0u);
}

Road with_point(Road made, std::uint32_t vertex, map::TrackPointKind kind) {
  made.points.push_back({vertex, kind, 0});
  return made;
}

TEST_F(Junctions, AtATurningCircleHaveOneArm) {
  const Outlined all = sound({with_point(road_of_width(1, {{0, 0}, {50, 0}}), 1, map::TrackPointKind::kTurningCircle)});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts, (std::vector<Cut>{{6, 0}}));
  double area = 0;
  for (const Polygon& polygon : all.outlines[0]) area += area_m2(polygon);
  EXPECT_NEAR(area, 36 * std::numbers::pi, 4);
}

TEST_F(Junctions, AMiniRoundaboutCoversItsDisk) {
  const Outlined all =
      sound({with_point(road_of_width(1, {{-50, 0}, {0, 0}, {50, 0}}, 9), 1, map::TrackPointKind::kMiniRoundabout),
             road_of_width(2, {{0, 0}, {0, 50}}, 5)});
  ASSERT_EQ(all.outlines.size(), 1u);
  ASSERT_EQ(all.outlines[0].size(), 1u);
  // half the wide road and a margin
  for (const Vec2 p : {Vec2{5.9, 0}, Vec2{-4.1, -4.1}, Vec2{0, -5.9}, Vec2{4.1, 4.1}})
    EXPECT_TRUE(contains(all.outlines[0][0], p)) << p.x << ' ' << p.y;
}

TEST_F(Junctions, OfFootpathsOnAStreetAreNone) {
  EXPECT_TRUE(sound({road_of_width(1, {{-50, 0}, {0, 0}, {50, 0}}),
                     road_of_width(2, {{0, -50}, {0, 0}, {0, 50}}, 2, LandCoverClass::kPavedFootPath)})
                  .junctions.empty());
}

TEST_F(Junctions, CutsOfOneLinkNeverOverlap) {
  const std::vector<Road> roads = {road_of_width(1, {{0, 0}, {20, 0}}),
                                   road_of_width(2, {{0, -50}, {0, 0}, {4, 50}}, 14),
                                   road_of_width(3, {{20, -50}, {20, 0}, {20, 50}}, 14)};
  const Outlined all = sound(roads);
  ASSERT_EQ(all.junctions.size(), 2u);
  const auto arms = arms_of(all.junctions, roads);
  const auto &first = arms[0], &second = arms[1];
  EXPECT_EQ(first[0].road, 0u);
  EXPECT_EQ(second[0].road, 0u);
  EXPECT_LE(all.junctions[0].cuts[0].length_m + all.junctions[1].cuts[0].length_m, 20);
}

TEST_F(Junctions, DoNotDependOnTheOrderOfRoads) {
  std::vector<Road> roads = {road_of_width(1, {{-50, 0}, {0, 0}, {50, 0}}),
                             road_of_width(2, {{0, -50}, {0, 0}, {3, 50}}, 8), road_of_width(3, {{0, 0}, {40, 30}}, 4)};
  const Outlined before = outlined(roads);
  std::ranges::reverse(roads);
  for (Road& r : roads) std::ranges::reverse(r.axis);
  const Outlined after = outlined(roads);
  ASSERT_EQ(after.outlines.size(), 1u);
  EXPECT_NEAR(area_m2(after.outlines[0][0]), area_m2(before.outlines[0][0]), 0.01);
}

// Streets every 15 to 40 m, close enough for their junctions to merge.
std::vector<Road> random_town(std::mt19937_64& chance) {
  std::vector<Road> roads;
  const auto lines = [&] {
    std::vector<double> at = {0};
    while (at.back() < 700) at.push_back(at.back() + 4 + static_cast<double>(chance() % 36));
    return at;
  };
  const std::vector<double> xs = lines(), ys = lines();
  const auto add = [&](Vec2 a, Vec2 b) {
    if (chance() % 4 != 0)
      roads.push_back(
          road_of_width(static_cast<std::int64_t>(roads.size()), {a, b}, 3 + static_cast<double>(chance() % 6)));
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      add({xs[i], ys[j]}, {xs[i + 1], ys[j]});
      add({xs[i], ys[j]}, {xs[i], ys[j + 1]});
    }
  return roads;
}

TEST_F(Junctions, DependOnNothingFartherThanEightReaches) {
  std::mt19937_64 chance(8);
  constexpr Vec2 kMiddle{350, 350};
  std::size_t compared = 0;
  for (int round = 0; round < 20; ++round) {
    const std::vector<Road> town = random_town(chance);
    std::vector<Road> near;
    for (const Road& r : town)
      if (distance(r.axis.front(), kMiddle) <= 8 * kJunctionRadius_m) near.push_back(r);
    const auto in_the_middle = [&](const std::vector<Road>& roads) {
      std::vector<Junction> found;
      Report ignored;
      for (Junction& junction : plan_junctions(roads, ignored))
        if (distance(junction.nodes.front(), kMiddle) < kJunctionRadius_m) found.push_back(std::move(junction));
      return found;
    };
    EXPECT_LT(near.size(), town.size());
    const std::vector<Junction> expected = in_the_middle(town);
    compared += expected.size();
    EXPECT_EQ(in_the_middle(near), expected) << "round " << round;
  }
  EXPECT_GT(compared, 0u);
}

TEST_F(Junctions, AreSoundHoweverRoadsMeet) {
  std::mt19937_64 chance(20261121);
  Faults faults;
  int outlines = 0;
  for (int round = 0, rounds = quick_or_full(5000, 100000); round < rounds; ++round) {
    const std::vector<Road> roads = random_roads(chance);
    const Outlined all = outlined(roads);
    const double beyond_m = beyond_reach_m(roads);
    for (std::size_t j = 0; j < all.junctions.size(); ++j)
      count_faults(all.junctions[j], all.outlines[j], beyond_m, faults), ++outlines;
    ASSERT_EQ(faults.self_crossing, 0) << "round " << round;
    ASSERT_EQ(faults.beyond_reach, 0) << "round " << round;
  }
  EXPECT_GT(outlines, quick_or_full(2500, 50000));
  RecordProperty("outlines", outlines);
  RecordProperty("spikes", faults.spikes);
}

}  // namespace
}  // namespace citykiln::roads
