#include "compiler/lots/courts.h"

#include <gtest/gtest.h>

namespace citykiln::lots {
namespace {

using map::LandCoverClass;

map::AreaFeature court_area(std::int64_t id, LandCoverClass surface, Vec2 low, double side_m) {
  const Vec2 high = low + Vec2{side_m, side_m};
  map::AreaFeature area;
  area.id = {{OsmType::kWay, id}, 0}, area.surface = surface, area.area_m2 = side_m * side_m;
  area.polygon.outer = {low, {high.x, low.y}, high, {low.x, high.y}};
  return area;
}

LotKind court_among(std::vector<map::AreaFeature> areas) {
  map::Features features;
  features.areas = std::move(areas);
  return court_of(index_court_green(features), {0, 0});
}

TEST(Courts, AreGreenAmongGreenAndPavedAmongPaving) {
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kGrass, {20, 20}, 10)}), LotKind::kGreenCourt);
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kParking, {20, 20}, 10)}), LotKind::kPavedCourt);
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kParking, {20, 20}, 10),
                         court_area(2, LandCoverClass::kGrass, {-30, 20}, 10)}),
            LotKind::kPerimeter);
}

TEST(Courts, AreDrawnWhereNothingIsMappedNear) {
  EXPECT_EQ(court_among({}), LotKind::kPerimeter);
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kGrass, {120, 0}, 10)}), LotKind::kPerimeter);
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kGrass, {-50, -50}, 90)}), LotKind::kPerimeter) << "a park";
}

TEST(Courts, OneLargeAreaCountsForNoMoreThanAUsualCourt) {
  EXPECT_EQ(court_among({court_area(1, LandCoverClass::kParking, {10, 10}, 60),
                         court_area(2, LandCoverClass::kGrass, {-40, 10}, 20),
                         court_area(3, LandCoverClass::kGrass, {-40, -40}, 20)}),
            LotKind::kGreenCourt);
}

TEST(Courts, AnAreaIsNoNeighbourOfItself) {
  map::Features features;
  features.areas = {court_area(1, LandCoverClass::kGrass, {20, 20}, 10)};
  const CourtGreen green = index_court_green(features);
  EXPECT_EQ(green_share(green, {0, 0}, {}), 1);
  EXPECT_EQ(green_share(green, {0, 0}, features.areas[0].id), std::nullopt);
}

}  // namespace
}  // namespace citykiln::lots
