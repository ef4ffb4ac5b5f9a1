#include "compiler/map/things/outline_places.h"

#include <gtest/gtest.h>

namespace citykiln::map {
namespace {

TEST(PlacesOnLine, BollardsAreOneAndAHalfMetresApart) {
  const auto places = places_on_line({{0, 0}, {6, 0}, {6, 6}}, Stand::kInWay, 0.14, 0.14);
  ASSERT_EQ(places.size(), 8u);
  EXPECT_EQ(places[0].at, (Vec2{0.75, 0}));
  EXPECT_EQ(places[7].at, (Vec2{6, 5.25}));
  for (const OutlinePlace& place : places) EXPECT_EQ(place.width_m, 0.14);
}

TEST(PlacesOnLine, WideCopiesTouch) {
  const auto places = places_on_line({{0, 0}, {9, 0}}, Stand::kInWay, 4, 0.6);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].at, (Vec2{2.25, 0}));
  EXPECT_EQ(places[0].width_m, 4.5);
  EXPECT_EQ(places[0].depth_m, 0.6);
  EXPECT_EQ(places[0].along, (Vec2{1, 0}));
}

TEST(PlacesOnLine, OtherThingsAreAsLongAsTheirLine) {
  const auto bench = places_on_line({{0, 0}, {0, 3}}, Stand::kGround, 1.8, 0.65);
  ASSERT_EQ(bench.size(), 1u);
  EXPECT_EQ(bench[0].at, (Vec2{0, 1.5}));
  EXPECT_EQ(bench[0].along, (Vec2{0, 1}));
  EXPECT_EQ(bench[0].width_m, 3);
  EXPECT_EQ(places_on_line({{0, 0}, {0, 30}}, Stand::kGround, 1.8, 0.65)[0].width_m, 1.8) << "no bench is that long";
}

TEST(PlacesOnLine, TheirNumberIsLimited) {
  EXPECT_EQ(places_on_line({{0, 0}, {50000, 0}}, Stand::kInWay, 0.14, 0.14).size(), kMostCopies);
}

TEST(PlaceInArea, IsTheSmallestRectangle) {
  // 4 m by 2 m, turned by the angle of a triangle of 3, 4 and 5
  const Ring ring{{0, 0}, {3.2, 2.4}, {2, 4}, {-1.2, 1.6}};
  const OutlinePlace place = place_in_area(ring, 3.2, 0.8);
  EXPECT_NEAR(place.at.x, 1, 1e-3);
  EXPECT_NEAR(place.at.y, 2, 1e-3);
  EXPECT_EQ(place.width_m, 4);
  EXPECT_EQ(place.depth_m, 2);
  EXPECT_NEAR(std::abs(place.along.x), 0.8, 1e-9);
  EXPECT_NEAR(std::abs(place.along.y), 0.6, 1e-9);
}

TEST(PlaceInArea, TheLongerSideIsTheLongerOneOfTheRow) {
  const OutlinePlace place = place_in_area({{0, 0}, {6, 0}, {6, 2}, {0, 2}}, 2, 3);
  EXPECT_EQ(place.width_m, 2);
  EXPECT_EQ(place.depth_m, 6);
  EXPECT_EQ(std::abs(place.along.y), 1);
}

TEST(PlaceInArea, AMuchLargerAreaKeepsTheSizeOfTheRow) {
  const OutlinePlace place = place_in_area({{0, 0}, {40, 0}, {40, 20}, {0, 20}}, 3, 1.5);
  EXPECT_EQ(place.at, (Vec2{20, 10}));
  EXPECT_EQ(place.width_m, 3);
  EXPECT_EQ(place.depth_m, 1.5);
}

}  // namespace
}  // namespace citykiln::map
