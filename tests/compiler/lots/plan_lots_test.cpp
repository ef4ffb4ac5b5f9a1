#include "compiler/lots/plan_lots.h"

#include <gtest/gtest.h>

#include "tests/compiler/lots/made_town.h"

namespace citykiln::lots {
namespace {

using map::BuildingClass;
using map::LandCoverClass;

LotKind kind_in(const map::Features& town) { return lots_of_town(town).at(3).kind; }

TEST(PlanLots, EveryHouseAlongAStreetHasALot) {
  const std::vector<Lot> lots = lots_of_town(made_town());
  ASSERT_EQ(lots.size(), 8u);
  for (std::size_t i = 0; i < lots.size(); ++i) {
    EXPECT_EQ(lots[i].main, i);
    EXPECT_EQ(lots[i].kind, LotKind::kDetached);
    // less what lies under the pavement
    EXPECT_NEAR(lots[i].setback_m, 8 + kUnderPavement_m, 0.01);
    EXPECT_GT(dot(frame_at(lots[i].frame).inward, Vec2{0, 1}), 0.99);
  }
}

TEST(PlanLots, KindsFollowLandUseAndBuilding) {
  map::Features town = made_town();
  const auto with = [&](BuildingClass own, LandCoverClass use) {
    map::Features changed = town;
    changed.areas[0].surface = use;
    changed.footprints[3].building_class = static_cast<std::uint8_t>(own);
    return kind_in(changed);
  };
  EXPECT_EQ(with(BuildingClass::kHouse, LandCoverClass::kIndustrial), LotKind::kWorks);
  EXPECT_EQ(with(BuildingClass::kHouse, LandCoverClass::kRetail), LotKind::kShop);
  EXPECT_EQ(with(BuildingClass::kApartments, LandCoverClass::kResidential), LotKind::kApartments);
  EXPECT_EQ(with(BuildingClass::kSchool, LandCoverClass::kResidential), LotKind::kPublic);
  EXPECT_EQ(with(BuildingClass::kGarage, LandCoverClass::kResidential), LotKind::kNone);
}

TEST(PlanLots, HousesThatTouchAreARow) {
  map::Features town = made_town();
  town.footprints[3].polygon.outer = rectangle({-24, 13}, {0, 23});
  town.footprints[4].polygon.outer = rectangle({0, 13}, {12, 23});
  EXPECT_EQ(kind_in(town), LotKind::kRow);
  EXPECT_EQ(lots_of_town(town).at(5).kind, LotKind::kDetached);
}

TEST(PlanLots, ADoorIsInTheWallTowardsTheFront) {
  for (const Lot& lot : lots_of_town(made_town())) {
    ASSERT_TRUE(lot.door);
    EXPECT_FALSE(lot.door->is_mapped);
    EXPECT_EQ(lot.door->at.y, 13);
    EXPECT_EQ(lot.door->outward, (Vec2{0, -1}));
  }
}

TEST(PlanLots, AMappedEntranceIsTheDoor) {
  map::Features town = made_town();
  town.points.push_back({.id = {{OsmType::kNode, 9}, 0}, .at = {-12, 20}, .kind = map::PointKind::kEntrance});
  const Lot lot = lots_of_town(town).at(3);
  ASSERT_TRUE(lot.door);
  EXPECT_TRUE(lot.door->is_mapped);
  EXPECT_EQ(lot.door->at, (Vec2{-12, 20}));
}

TEST(PlanLots, LandThatIsMappedMoreFinelyIsInNoLot) {
  map::Features town = made_town();
  town.areas.push_back(land(51, {-24, 25}, {-12, 40}, LandCoverClass::kGarden));
  for (const Lot& lot : lots_of_town(town)) EXPECT_FALSE(contains(lot.parcel.polygon, {-18, 30}));
  EXPECT_TRUE(contains(lots_of_town(made_town()).at(3).parcel.polygon, {-18, 30}));
}

// The houses of the street stand behind a path along it.
TEST(PlanLots, APathAlongAStreetIsItsPavement) {
  map::Features town = made_town();
  town.tracks.push_back(path(2, {{-150, 8}, {0, 8}, {150, 8}}));
  for (const Lot& lot : lots_of_town(town)) EXPECT_NEAR(lot.setback_m, 4 + kUnderPavement_m, 0.01);
  town.tracks.back().axis = {{-150, 30}, {150, 30}};
  for (const Lot& lot : lots_of_town(town)) EXPECT_NEAR(lot.setback_m, 8 + kUnderPavement_m, 0.01);
}

}  // namespace
}  // namespace citykiln::lots
