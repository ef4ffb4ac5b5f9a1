#include "compiler/roads/junction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/geometry/snap.h"
#include "tests/compiler/roads/junction_claims.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

using map::SurfaceClass;

Road road(std::int64_t id, Polyline axis, double width_m = 6, SurfaceClass surface = SurfaceClass::kResidentialRoad) {
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
  all.outlines = outline(all.junctions, roads, 1);
  return all;
}

class Junctions : public testing::Test {
 protected:
  // Every case keeps every promise, whatever else it shows.
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

TEST_F(Junctions, ARoadThatEndsAloneHasNone) { EXPECT_TRUE(sound({road(1, {{0, 0}, {50, 0}})}).junctions.empty()); }

TEST_F(Junctions, ARoadThatGoesOnUnderAnotherNameHasNone) {
  EXPECT_TRUE(sound({road(1, {{0, 0}, {50, 0}}), road(2, {{50, 0}, {100, 5}})}).junctions.empty());
}

TEST_F(Junctions, TwoWidthsMeetInOne) {
  const Outlined all = sound({road(1, {{0, 0}, {50, 0}}, 6), road(2, {{50, 0}, {100, 5}}, 10)});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts.size(), 2u);
  EXPECT_EQ(all.outlines[0].size(), 1u);
}

TEST_F(Junctions, ACrossingIsCutSquareBehindItsRoundedCorners) {
  const Outlined all = sound({road(1, {{-50, 0}, {0, 0}, {50, 0}}), road(2, {{0, -50}, {0, 0}, {0, 50}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  // half the other road and the kerb's radius
  for (const Cut& cut : all.junctions[0].cuts) EXPECT_EQ(cut, (Cut{8, 5}));
  // a cross of arms 6 wide and 16 long, and four corners outside of a circle of 5
  EXPECT_NEAR(area_m2(all.outlines[0][0]), 2 * 16 * 6 - 36 + 4 * 25 * (1 - std::numbers::pi / 4), 0.6);
}

TEST_F(Junctions, ARampLeavesItsMotorwayWithinReach) {
  const Outlined all = sound({road(1, {{-80, 0}, {0, 0}, {80, 0}}, 11, SurfaceClass::kMotorwayRoad),
                              road(2, {{0, 0}, {40, 4}, {80, 14}}, 5, SurfaceClass::kMotorwayRoad)});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_LE(std::ranges::max(all.junctions[0].cuts, {}, &Cut::length_m).length_m, kReach_m);
}

TEST_F(Junctions, ArmsSideBySideAreCutAtTheReach) {
  const Outlined all =
      sound({road(1, {{0, 0}, {100, 0}}), road(2, {{0, 0}, {100, 0.5}}), road(3, {{0, 0}, {-100, 0}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(std::ranges::max(all.junctions[0].cuts, {}, &Cut::length_m).length_m, kReach_m);
}

TEST_F(Junctions, AnArmShorterThanItsCutIsSwallowed) {
  const Outlined all = sound({road(1, {{-50, 0}, {0, 0}, {50, 0}}), road(2, {{0, 0}, {0, 2}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.report.counts()[Code::kArmSwallowed], 1u);
}

TEST_F(Junctions, ALoopAtOneNodeHasTwoArmsThere) {
  const Outlined all = sound({road(1, {{0, 0}, {30, 10}, {40, 0}, {30, -10}, {0, 0}}), road(2, {{0, 0}, {-50, 0}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].cuts.size(), 3u);
}

TEST_F(Junctions, OfTwoRoadsThatShareBothEndsAreTwo) {
  const Outlined all = sound({road(1, {{0, 0}, {25, 8}, {50, 0}}), road(2, {{0, 0}, {25, -8}, {50, 0}}),
                              road(3, {{-40, 0}, {0, 0}}), road(4, {{50, 0}, {90, 0}})});
  EXPECT_EQ(all.junctions.size(), 2u);
}

TEST_F(Junctions, ADogLegIsOneJunction) {
  const Outlined all =
      sound({road(1, {{-50, 0}, {0, 0}, {5, 0}, {50, 0}}), road(2, {{0, 0}, {0, 50}}), road(3, {{5, 0}, {5, -50}})});
  ASSERT_EQ(all.junctions.size(), 1u);
  EXPECT_EQ(all.junctions[0].places.size(), 2u);
  EXPECT_EQ(all.report.counts()[Code::kJunctionsMerged], 1u);
}

TEST_F(Junctions, OfFootpathsOnAStreetAreNone) {
  EXPECT_TRUE(sound({road(1, {{-50, 0}, {0, 0}, {50, 0}}),
                     road(2, {{0, -50}, {0, 0}, {0, 50}}, 2, SurfaceClass::kPavedFootPath)})
                  .junctions.empty());
}

TEST_F(Junctions, CutsOfOneLinkNeverOverlap) {
  const std::vector<Road> roads = {road(1, {{0, 0}, {20, 0}}), road(2, {{0, -50}, {0, 0}, {4, 50}}, 14),
                                   road(3, {{20, -50}, {20, 0}, {20, 50}}, 14)};
  const Outlined all = sound(roads);
  ASSERT_EQ(all.junctions.size(), 2u);
  const auto first = arms_at(roads, all.junctions[0].places, Family::kStreet),
             second = arms_at(roads, all.junctions[1].places, Family::kStreet);
  EXPECT_EQ(first[0].road, 0u);
  EXPECT_EQ(second[0].road, 0u);
  EXPECT_LE(all.junctions[0].cuts[0].length_m + all.junctions[1].cuts[0].length_m, 20);
}

TEST_F(Junctions, DoNotDependOnTheOrderOfRoads) {
  std::vector<Road> roads = {road(1, {{-50, 0}, {0, 0}, {50, 0}}), road(2, {{0, -50}, {0, 0}, {3, 50}}, 8),
                             road(3, {{0, 0}, {40, 30}}, 4)};
  const Outlined before = outlined(roads);
  std::ranges::reverse(roads);
  for (Road& r : roads) std::ranges::reverse(r.axis);
  const Outlined after = outlined(roads);
  ASSERT_EQ(after.outlines.size(), 1u);
  EXPECT_NEAR(area_m2(after.outlines[0][0]), area_m2(before.outlines[0][0]), 0.01);
}

// Streets every 15 to 40 m, so that junctions are close enough to merge.
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
      roads.push_back(road(static_cast<std::int64_t>(roads.size()), {a, b}, 3 + static_cast<double>(chance() % 6)));
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
  for (int round = 0; round < 20; ++round) {
    const std::vector<Road> town = random_town(chance);
    std::vector<Road> near;
    for (const Road& r : town)
      if (distance(r.axis.front(), kMiddle) <= 8 * kReach_m) near.push_back(r);
    const auto in_the_middle = [&](const std::vector<Road>& roads) {
      std::vector<Junction> found;
      Report ignored;
      for (Junction& junction : plan_junctions(roads, ignored))
        if (distance(junction.places.front(), kMiddle) < kReach_m) found.push_back(std::move(junction));
      return found;
    };
    EXPECT_LT(near.size(), town.size());
    EXPECT_EQ(in_the_middle(near), in_the_middle(town)) << "round " << round;
  }
}

// 1 to 12 arms, angles down to 0.01°, lengths from 1 mm, widths to 60 m; now and then a second place close by.
std::vector<Road> random_roads(std::mt19937_64& chance) {
  const auto unit = [&] { return static_cast<double>(chance() % 1000001) / 1e6; };
  std::vector<Road> roads;
  const int arms = 1 + static_cast<int>(chance() % 12);
  double angle = 0;
  Vec2 place{0, 0};
  for (int a = 0; a < arms; ++a) {
    angle += chance() % 3 == 0 ? 0.01 * std::numbers::pi / 180 : unit() * 2 * std::numbers::pi / arms;
    const double reach = 0.001 * std::pow(10.0, unit() * 5.3),
                 width = chance() % 10 == 0 ? 0.25 + unit() * 59.75 : 1 + unit() * 12;
    Polyline axis = {place};
    const int points = 1 + static_cast<int>(chance() % 3);
    for (int i = 1; i <= points; ++i) {
      const double bend = angle + (i - 1) * (unit() - 0.5) * 2;
      const Vec2 next = snapped(axis.back() + Vec2{std::cos(bend), std::sin(bend)} * (reach / points));
      if (next != axis.back()) axis.push_back(next);
    }
    if (axis.size() < 2) continue;
    if (chance() % 8 == 0) place = axis.back();
    const auto surface = chance() % 2 == 0 ? SurfaceClass::kPrimaryRoad : SurfaceClass::kResidentialRoad;
    roads.push_back(road(a + 1, std::move(axis), snapped(width) > 0 ? snapped(width) : 1, surface));
  }
  return roads;
}

TEST_F(Junctions, AreSoundHoweverRoadsMeet) {
  std::mt19937_64 chance(20261121);
  Faults faults;
  int outlines = 0;
  for (int round = 0; round < 100000; ++round) {
    const std::vector<Road> roads = random_roads(chance);
    const Outlined all = outlined(roads);
    const double beyond_m = beyond_reach_m(roads);
    for (std::size_t j = 0; j < all.junctions.size(); ++j)
      count_faults(all.junctions[j], all.outlines[j], beyond_m, faults), ++outlines;
    ASSERT_EQ(faults.self_crossing, 0) << "round " << round;
    ASSERT_EQ(faults.beyond_reach, 0) << "round " << round;
  }
  EXPECT_GT(outlines, 50000);
  RecordProperty("outlines", outlines);
  RecordProperty("spikes", faults.spikes);
}

}  // namespace
}  // namespace citykiln::roads
