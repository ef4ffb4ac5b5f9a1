#include "compiler/buildings/planning/plan_roof.h"

#include <gtest/gtest.h>

#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using roofs::RoofForm;

map::Footprint of_class(BuildingClass building, double width_m, double depth_m, double height_m) {
  map::Footprint f = rectangle(1, {0, 0}, width_m, depth_m, height_m);
  f.building_class = static_cast<std::uint8_t>(building);
  return f;
}

map::Footprint told(RoofForm form, double roof_m) {
  map::Footprint f = of_class(BuildingClass::kHouse, 12, 9, 8);
  f.has_roof_shape = true;
  f.roof.form = form, f.roof.height_m = roof_m;
  return f;
}

TEST(PlanRoof, UsesTaggedFormAndHeight) {
  const roofs::RoofShape roof = plan_roof(told(RoofForm::kMansard, 2.5), {});
  EXPECT_EQ(roof.form, RoofForm::kMansard);
  EXPECT_EQ(roof.height_m, 2.5);
  EXPECT_EQ(plan_roof(told(RoofForm::kFlat, 2.5), {}), roofs::RoofShape{});
}

TEST(PlanRoof, NeverRisesHigherThanTheBuilding) {
  EXPECT_EQ(plan_roof(told(RoofForm::kGabled, 30), {}).height_m, 8);
  map::Footprint lifted = told(RoofForm::kDome, 30);
  lifted.min_height_m = 6;
  EXPECT_EQ(plan_roof(lifted, {}).height_m, 2);
  // and leaves room for a storey if its height is not tagged
  EXPECT_LE(plan_roof(told(RoofForm::kCone, 0), {}).height_m, 4);
}

TEST(PlanRoof, HasThePitchOfItsFormWithoutATaggedHeight) {
  map::Footprint f = told(RoofForm::kGabled, 0);
  f.has_roof_in_height = false;
  f.roof.angle_deg = 45;
  EXPECT_NEAR(plan_roof(f, {}).height_m, 4.5, 0.01);
  EXPECT_EQ(plan_roof(f, {}).angle_deg, 0);
}

TEST(PlanRoof, GivesHousesPitchedRoofsAndBlocksFlatOnes) {
  EXPECT_NE(plan_roof(of_class(BuildingClass::kHouse, 12, 9, 8), {}).form, RoofForm::kFlat);
  EXPECT_EQ(plan_roof(of_class(BuildingClass::kApartments, 60, 30, 20), {}).form, RoofForm::kFlat);
  EXPECT_EQ(plan_roof(of_class(BuildingClass::kGarage, 6, 6, 3), {}).form, RoofForm::kFlat);
  map::Footprint part = of_class(BuildingClass::kHouse, 12, 9, 8);
  part.is_part = true;
  EXPECT_EQ(plan_roof(part, {}).form, RoofForm::kFlat);
}

TEST(PlanRoof, HasItsRidgeAlongTheStreetInARow) {
  const roofs::RoofShape roof = plan_roof(of_class(BuildingClass::kHouse, 6, 12, 8), {true, Vec2{0, -1}});
  EXPECT_EQ(roof.form, RoofForm::kGabled);
  ASSERT_TRUE(roof.direction);
  EXPECT_EQ(*roof.direction, (Vec2{0, -1}));
  EXPECT_EQ(roof.overhang_m, 0);
  EXPECT_GT(plan_roof(of_class(BuildingClass::kHouse, 6, 12, 8), {}).overhang_m, 0);
}

TEST(PlanRoof, IsOnTheGrid) {
  for (double width_m = 5; width_m < 15; width_m += 0.37) {
    map::Footprint f = of_class(BuildingClass::kHouse, width_m, 11.3, 40);
    f.has_roof_in_height = false;
    const roofs::RoofShape roof = plan_roof(f, {});
    EXPECT_EQ(roof.height_m, snapped(roof.height_m));
  }
}

TEST(PlanRoof, IsFlatInsteadOfVeryLow) {
  EXPECT_EQ(plan_roof(told(RoofForm::kGabled, 0.2), {}), roofs::RoofShape{});
  EXPECT_EQ(plan_roof(told(RoofForm::kGabled, 0.25), {}).form, RoofForm::kGabled);
}

TEST(PlanRoof, HasNeitherAngleNorLevels) {
  map::Footprint f = told(RoofForm::kGabled, 0);
  f.roof.levels = 1;
  EXPECT_EQ(plan_roof(f, {}).levels, 0);
}

TEST(PlanRoof, OfAttachedHousesIsAGable) {
  for (std::int64_t id = 1; id < 60; ++id) {
    map::Footprint f = of_class(BuildingClass::kHouse, 8, 10, 8);
    f.id.osm.id = id;
    EXPECT_EQ(plan_roof(f, {true, Vec2{0, -1}}).form, RoofForm::kGabled);
  }
}

TEST(PlanRoof, LeavesAStoreyBelowUntaggedRoofHeights) {
  map::Footprint f = of_class(BuildingClass::kHouse, 12, 9, 4);
  EXPECT_LE(plan_roof(f, {}).height_m, 4 - 2.25);
  f = of_class(BuildingClass::kHouse, 12, 9, 8);
  EXPECT_LE(plan_roof(f, {}).height_m, 4);
}

TEST(PlanRoof, OfHallsIsLowAndOfWideOnesFlat) {
  const roofs::RoofShape hall = plan_roof(of_class(BuildingClass::kHall, 40, 20, 30), {});
  EXPECT_EQ(hall.form, RoofForm::kGabled);
  EXPECT_NEAR(hall.height_m, 10 * 0.158, 0.01);
  EXPECT_EQ(plan_roof(of_class(BuildingClass::kHall, 80, 60, 30), {}).form, RoofForm::kFlat);
}

TEST(PlanRoof, IsGabledOnLargerHutsAlone) {
  EXPECT_EQ(plan_roof(of_class(BuildingClass::kHut, 2, 3, 5), {}).form, RoofForm::kFlat);
  EXPECT_EQ(plan_roof(of_class(BuildingClass::kHut, 5, 4, 5), {}).form, RoofForm::kGabled);
}

TEST(PlanRoof, OfPartsHasNoEaves) {
  map::Footprint part = told(RoofForm::kGabled, 2);
  EXPECT_GT(plan_roof(part, {}).overhang_m, 0);
  part.is_part = true;
  EXPECT_EQ(plan_roof(part, {}).overhang_m, 0);
}

}  // namespace
}  // namespace citykiln::buildings
