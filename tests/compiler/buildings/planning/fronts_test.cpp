#include "compiler/buildings/planning/fronts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/map/buildings/building_classes.h"
#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

map::FrontPoint shop(std::int64_t id, double x, double y, map::FrontKind kind = map::FrontKind::kShop) {
  return {{{OsmType::kNode, id}, 0}, {x, y}, {kind, {}}, false};
}

map::PointFeature entrance(double x, double y) {
  map::PointFeature point;
  point.at = {x, y}, point.kind = map::PointKind::kEntrance;
  return point;
}

// Houses north of a street along y = -8.
struct FrontStreet {
  std::vector<map::Footprint> footprints;
  std::vector<map::PointFeature> doors{};
  std::vector<map::Passageway> passageways{};
  Report report{};

  std::vector<std::vector<Front>> fronts(const std::vector<map::FrontPoint>& points) {
    map::Track street;
    street.axis = {{-200, -8}, {200, -8}};
    street.surface = map::LandCoverClass::kResidentialRoad;
    const auto shared = shared_walls(footprints);
    return plan_fronts(
        points, {footprints, shared, index_streets(std::vector{street}), index_doors(doors), passageways}, report);
  }
};

TEST(Fronts, AreInTheWallTowardsTheStreet) {
  FrontStreet houses{{rectangle(1, {0, 0}, 10, 12, 12)}, {entrance(10, 9)}};
  // nearer to the western wall, which faces no street
  const auto fronts = houses.fronts({shop(5, 1, 6, map::FrontKind::kCafe)});
  ASSERT_EQ(fronts[0].size(), 1u);
  EXPECT_EQ(fronts[0][0], (Front{.edge = 0, .from_m = 0, .to_m = 10, .kind = map::FrontKind::kCafe}));
  EXPECT_EQ(houses.report.ledger().at("buildings/front").out, 1u);
}

TEST(Fronts, OfPointsOutsideGoToTheNearestHouse) {
  FrontStreet houses{{rectangle(1, {0, 0}, 10, 12, 12), rectangle(2, {10, 0}, 10, 12, 12)}};
  const auto fronts = houses.fronts({shop(5, 12, -1.25), shop(6, 12, -2)});
  EXPECT_TRUE(fronts[0].empty());
  EXPECT_EQ(fronts[1].size(), 1u);
  EXPECT_EQ(houses.report.counts().at(Code::kNoWallForFront), 1u);
}

TEST(Fronts, ShareAWallInOrder) {
  FrontStreet houses{{rectangle(1, {0, 0}, 18, 12, 12)}, {entrance(18, 9)}};
  const auto fronts = houses.fronts({shop(5, 14, 3), shop(6, 2, 3, map::FrontKind::kBank), shop(7, 9, 9)});
  ASSERT_EQ(fronts[0].size(), 3u);
  EXPECT_EQ(fronts[0][0].kind, map::FrontKind::kBank);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(fronts[0][i].from_m, 6.0 * i) << i;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(fronts[0][i].to_m, 6.0 * (i + 1)) << i;
}

TEST(Fronts, AreNoWiderThanTwelveMetresAndLieAboutTheirPoint) {
  FrontStreet houses{{rectangle(1, {0, 0}, 60, 12, 12)}, {entrance(60, 9)}};
  const auto fronts = houses.fronts({shop(5, 40, 3)});
  ASSERT_EQ(fronts[0].size(), 1u);
  EXPECT_EQ(fronts[0][0].from_m, 34);
  EXPECT_EQ(fronts[0][0].to_m, 46);
}

TEST(Fronts, LeaveMappedDoorsFree) {
  FrontStreet houses{{rectangle(1, {0, 0}, 16, 12, 12)}, {entrance(8.5, 0)}};
  const auto fronts = houses.fronts({shop(5, 3, 3), shop(6, 13, 3)});
  ASSERT_EQ(fronts[0].size(), 2u);
  EXPECT_EQ(fronts[0][0].to_m, 7.25);
  EXPECT_EQ(fronts[0][1].from_m, 9.75);
}

TEST(Fronts, LeaveRoomForADoorIfNoneIsMapped) {
  FrontStreet houses{
      {rectangle(1, {0, 0}, 10, 12, 12), rectangle(2, {30, 0}, 20, 12, 12), rectangle(3, {60, 0}, 4, 12, 12)}};
  const auto fronts = houses.fronts({shop(5, 2, 3), shop(6, 34, 3), shop(7, 46, 3), shop(8, 62, 3)});
  // beside a single front, in the middle of two, nowhere in a wall of 4 m
  ASSERT_EQ(fronts[0].size(), 1u);
  EXPECT_EQ(fronts[0][0].to_m, 7.5);
  ASSERT_EQ(fronts[1].size(), 2u);
  EXPECT_GE(fronts[1][1].from_m - fronts[1][0].to_m, kDoorTile_m);
  ASSERT_EQ(fronts[2].size(), 1u);
  EXPECT_EQ(fronts[2][0].to_m - fronts[2][0].from_m, 4);
}

TEST(Fronts, AreNotAtPartyWalls) {
  // the western house's eastern wall is the nearest, but the other house stands against it
  FrontStreet houses{{rectangle(1, {0, 0}, 10, 12, 12), rectangle(2, {10, 0}, 10, 12, 12)}, {entrance(0, 9)}};
  const auto fronts = houses.fronts({shop(5, 9.5, 6)});
  ASSERT_EQ(fronts[0].size(), 1u);
  EXPECT_EQ(fronts[0][0].edge, 0u);
}

TEST(Fronts, AreNotInOpeningsForWays) {
  FrontStreet houses{{rectangle(1, {0, 0}, 20, 12, 12)}, {entrance(20, 9)}};
  houses.passageways.push_back({.building = houses.footprints[0].id,
                                .way = {{OsmType::kWay, 9}, 0},
                                .axis = {{4, -1}, {4, 13}},
                                .left_m = 2,
                                .right_m = 2});
  const auto fronts = houses.fronts({shop(5, 4, 3)});
  ASSERT_EQ(fronts[0].size(), 1u);
  EXPECT_GE(fronts[0][0].from_m, 6);
}

TEST(Fronts, AreNarrowerThanTwoAndAHalfMetresNowhere) {
  FrontStreet houses{{rectangle(1, {0, 0}, 8, 12, 12)}, {entrance(8, 9)}};
  std::vector<map::FrontPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back(shop(5 + i, 1 + i, 3));
  const auto fronts = houses.fronts(points);
  EXPECT_EQ(fronts[0].size(), 3u);
  for (const Front& front : fronts[0]) EXPECT_GE(front.to_m - front.from_m, kLeastFront_m);
  EXPECT_EQ(houses.report.counts().at(Code::kNoWallForFront), 2u);
  EXPECT_TRUE(houses.report.balances());
}

TEST(Fronts, DoNotDependOnTheOrderOfPoints) {
  FrontStreet houses{{rectangle(1, {0, 0}, 18, 12, 12)}};
  std::vector<map::FrontPoint> points{shop(5, 14, 3), shop(6, 2, 3, map::FrontKind::kBank), shop(7, 9, 9)};
  const auto fronts = houses.fronts(points);
  std::ranges::reverse(points);
  EXPECT_EQ(houses.fronts(points), fronts);
}

TEST(Fronts, AreNotInHallsChurchesAndRoofs) {
  map::Footprint church = rectangle(1, {0, 0}, 10, 12, 12), roof = church, lifted = church;
  church.building_class = static_cast<std::uint8_t>(map::BuildingClass::kChurch);
  roof.is_open = true, lifted.min_height_m = 4;
  for (const map::Footprint& footprint : {church, roof, lifted}) {
    FrontStreet houses{{footprint}};
    EXPECT_TRUE(houses.fronts({shop(5, 5, 3)})[0].empty());
  }
}

}  // namespace
}  // namespace citykiln::buildings
