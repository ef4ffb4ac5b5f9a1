#include "compiler/things/free_places.h"

#include <gtest/gtest.h>

namespace citykiln::things {
namespace {

using map::LandCoverClass;

ground::LandCoverPolygon rectangle(std::int64_t id, Vec2 low, Vec2 high, LandCoverClass surface) {
  ground::LandCoverPolygon polygon;
  polygon.id = {{OsmType::kWay, id}, 0};
  polygon.surface = surface;
  polygon.rings = {{low, {high.x, low.y}, high, {low.x, high.y}}};
  return polygon;
}

// A street from y = -3 to 3 with a pavement up to 5 and a building from 8 on.
std::vector<ground::LandCoverPolygon> kerbed_street() {
  return {rectangle(1, {-50, -3}, {50, 3}, LandCoverClass::kResidentialRoad),
          rectangle(2, {-50, 3}, {50, 5}, LandCoverClass::kPavement),
          rectangle(3, {-50, 8}, {50, 20}, LandCoverClass::kBuilding)};
}

TEST(FreePlaces, CarriagewaysWallsAndWaterAreNotFree) {
  const auto cover = kerbed_street();
  FreePlaces places(cover);
  EXPECT_FALSE(places.is_free({0, 0}, 0));
  EXPECT_TRUE(places.is_free({0, 4}, 0.5));
  EXPECT_FALSE(places.is_free({0, 3.25}, 0.5)) << "half in the carriageway";
  EXPECT_TRUE(places.is_free({0, 6}, 0.5));
  EXPECT_FALSE(places.is_free({0, 9}, 0));
}

TEST(FreePlaces, AThingIsMovedByAtMost3Metres) {
  const auto cover = kerbed_street();
  FreePlaces places(cover);
  EXPECT_EQ(places.nearest_free({0, 4}, 0.5), (Vec2{0, 4})) << "free already";
  const std::optional<Vec2> moved = places.nearest_free({0, 2}, 0.5);
  ASSERT_TRUE(moved);
  EXPECT_LE(distance(*moved, {0, 2}), 1.75);
  EXPECT_TRUE(places.is_free(*moved, 0.5));
  EXPECT_FALSE(places.nearest_free({0, 14}, 0.5)) << "deep in the building";
}

TEST(FreePlaces, ANodeOfARoadGoesAcrossItsAxisToTheKerb) {
  const auto cover = kerbed_street();
  FreePlaces places(cover);
  const std::optional<Vec2> left = places.first_free({0, 0}, {0, 1}, 0.25),
                            right = places.first_free({0, 0}, {0, -1}, 0);
  ASSERT_TRUE(left && right);
  EXPECT_EQ(*left, (Vec2{0, 3.25}));
  EXPECT_GE(right->y, -3.25);
}

TEST(FreePlaces, AWallFacesOutOfItsBuilding) {
  const auto cover = kerbed_street();
  FreePlaces places(cover);
  const std::optional<WallPlace> wall = places.nearest_wall({3, 6}, 0.3);
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->at, (Vec2{3, 8}));
  EXPECT_EQ(wall->out, (Vec2{0, -1}));
  EXPECT_FALSE(places.nearest_wall({3, -10}, 0.3));
}

TEST(FreePlaces, AWallBeforeWhichNothingMayStandIsNotUsed) {
  auto cover = kerbed_street();
  cover.push_back(rectangle(4, {-50, 6}, {50, 8}, LandCoverClass::kBuilding));
  FreePlaces places(cover);
  const std::optional<WallPlace> wall = places.nearest_wall({3, 7.5}, 0.3);
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->at, (Vec2{3, 6})) << "the walls at y = 8 touch";
}

}  // namespace
}  // namespace citykiln::things
