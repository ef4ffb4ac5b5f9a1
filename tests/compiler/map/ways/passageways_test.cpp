#include "compiler/map/ways/passageways.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

std::vector<Passageway> passageways_of(const std::string& text, Report& report) {
  return plan_passageways(features_of(text), report);
}
std::vector<Passageway> passageways_of(const std::string& text) {
  Report report;
  return passageways_of(text, report);
}

// 40 m by 12 m.
const std::string kHouse = "a1 0:0 40:0 40:12 0:12 building=apartments height=15\n";

TEST(Passageways, ATaggedPassageIsAsWideAndAsHighAsTagged) {
  const auto all =
      passageways_of(kHouse + "w2 20:0 20:12 highway=service tunnel=building_passage width=4 maxheight=3.5");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].left_m + all[0].right_m, 4, 0.2);
  EXPECT_GE(all[0].left_m + all[0].right_m, 4);
  EXPECT_NEAR(all[0].clear_m, 3.5, 0.1);
  EXPECT_GE(all[0].clear_m, 3.5);
}

TEST(Passageways, ContinueBeyondTheWalls) {
  const auto all = passageways_of(kHouse + "w2 20:0 20:12 highway=service tunnel=building_passage");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_LT(all[0].axis.front().y, -0.25);
  EXPECT_GT(all[0].axis.back().y, 12.25);
}

TEST(Passageways, AnObliqueOneContinuesUntilBothSidesAreOutside) {
  const auto all = passageways_of(kHouse + "w2 10:0 22:12 highway=service tunnel=building_passage width=4");
  ASSERT_EQ(all.size(), 1u);
  // the side at 2 m leaves the wall 2 m later
  EXPECT_LT(all[0].axis.front().y, -1.4);
  EXPECT_GT(all[0].axis.back().y, 13.4);
}

TEST(Passageways, OneBesideACornerContinuesPastIt) {
  // the corner at 0:0 stands in the opening, between its axis and its left side
  const auto all = passageways_of(kHouse + "w2 1:0.5 4:12 highway=service tunnel=building_passage width=4");
  ASSERT_EQ(all.size(), 1u);
  const Vec2 along = unit(all[0].axis.back() - all[0].axis.front());
  EXPECT_GT(dot(along, Vec2{0, 0} - all[0].axis.front()), 0.25);
}

TEST(Passageways, EachHouseOfARowHasOne) {
  const auto all = passageways_of(kHouse + "a3 0:12 40:12 40:24 0:24 building=house height=9\n" +
                                  "w2 12:-1 24:25 highway=service tunnel=building_passage");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].building.osm.id, 1);
  EXPECT_EQ(all[1].building.osm.id, 3);
}

TEST(Passageways, AnUntaggedWayHasOneWhereItCrossesFromSideToSide) {
  Report report;
  EXPECT_EQ(passageways_of(kHouse + "w2 20:-20 20:30 highway=footway", report).size(), 1u);
  EXPECT_EQ(report.counts()[Code::kPassageAssumed], 1u);
}

TEST(Passageways, AnUntaggedWayThatEndsInsideHasNone) {
  EXPECT_TRUE(passageways_of(kHouse + "w2 20:-20 20:6 highway=footway").empty());
}

TEST(Passageways, AnUntaggedWayThatCutsACornerHasNone) {
  EXPECT_TRUE(passageways_of(kHouse + "w2 -10:9 10:14 highway=residential").empty());
}

TEST(Passageways, AWayAlongAWallHasNone) {
  EXPECT_TRUE(passageways_of(kHouse + "w2 -10:0 50:0 highway=footway covered=yes").empty());
}

TEST(Passageways, IndoorWaysBridgesAndOpenRoofsHaveNone) {
  for (const char* tags :
       {"highway=corridor indoor=yes", "highway=footway level=1", "highway=footway bridge=yes layer=1"})
    EXPECT_TRUE(passageways_of(kHouse + "w2 20:-20 20:30 " + tags).empty()) << tags;
  EXPECT_TRUE(
      passageways_of("a1 0:0 40:0 40:12 0:12 building=roof\nw2 20:-20 20:30 highway=service covered=yes").empty());
}

TEST(Passageways, APartAboveTheWayHasNone) {
  EXPECT_TRUE(passageways_of("a1 0:0 40:0 40:12 0:12 building:part=yes min_height=4 height=15\n"
                             "w2 20:-20 20:30 highway=footway")
                  .empty());
}

TEST(Passageways, ATunnelWithoutALayerThatLiesInABuildingIsOnTheGround) {
  const Features through = features_of(kHouse + "w2 20:-1 20:13 highway=footway tunnel=yes");
  ASSERT_EQ(through.tracks.size(), 1u);
  EXPECT_EQ(through.tracks[0].passage, Passage::kGround);
  EXPECT_TRUE(through.tracks[0].is_covered);
  const Features deep = features_of(kHouse + "w2 20:-1 20:13 highway=footway tunnel=yes layer=-1");
  EXPECT_EQ(deep.tracks[0].passage, Passage::kTunnel);
  const Features far = features_of(kHouse + "w2 20:-30 20:40 highway=footway tunnel=yes");
  EXPECT_EQ(far.tracks[0].passage, Passage::kTunnel);
}

TEST(Passageways, AnArcadeIsOpenThroughItsOuterWallWherePillarsStand) {
  const auto all = passageways_of(kHouse + "w2 -2:1.5 42:1.5 highway=footway tunnel=building_passage width=2");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_GT(all[0].right_m, 1.5);
  EXPECT_NEAR(all[0].left_m, 1, 0.1);
  EXPECT_GT(all[0].pillars_right_m, 1.2);
  EXPECT_EQ(all[0].pillars_left_m, 0);
}

TEST(Passageways, AnArcadeIsAsWideAsAWayThatStandsOutOfItsOuterWall) {
  const auto all = passageways_of(kHouse + "w2 -2:1.1 42:1.1 highway=service covered=yes width=5");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_GE(all[0].right_m, 2.5);
  EXPECT_EQ(all[0].pillars_right_m, 0) << "pillars would stand in front of the wall";
}

TEST(Passageways, AnArcadeKeepsItsWallWhereAnotherHouseStands) {
  const auto all = passageways_of(kHouse + "a3 0:-9 40:-9 40:0 0:0 building=house height=9\n" +
                                  "w2 -2:1.5 42:1.5 highway=footway tunnel=building_passage width=2");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].pillars_right_m, 0);
}

TEST(Passageways, DoNotDependOnTheOrderOfElements) {
  const std::string way = "w2 20:-20 20:30 highway=footway", path = "w3 30:-20 30:30 highway=service covered=yes";
  EXPECT_EQ(passageways_of(kHouse + way + "\n" + path), passageways_of(path + "\n" + kHouse + way));
}

}  // namespace
}  // namespace citykiln::map
