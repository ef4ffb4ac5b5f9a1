#include "compiler/ground/cover/close_gaps.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::ground {
namespace {

// A car park from y = low to 20, beside a street of 6 m along y = 0.
Ring closed_park(double low_m, map::LandCoverClass surface = map::LandCoverClass::kParking) {
  const std::vector<roads::Road> roads = {roads::made_road(1, {{-50, 0}, {150, 0}}, 6)};
  return with_closed_gaps({{{{OsmType::kWay, 2}, 0}, surface, 0, {{{0, low_m}, {100, low_m}, {100, 20}, {0, 20}}}}},
                          roads)[0]
      .rings[0];
}

TEST(CloseGaps, CarParksReachUnderTheEdgeOfAStreetLessThanAGapAway) {
  const Ring moved = closed_park(3.5);
  EXPECT_EQ(moved[0], (Vec2{0, 3 - kUnderEdge_m}));
  EXPECT_EQ(moved[1], (Vec2{100, 3 - kUnderEdge_m}));
  EXPECT_EQ(moved[2], (Vec2{100, 20}));
}

TEST(CloseGaps, WiderGapsAndOtherAreasStay) {
  EXPECT_EQ(closed_park(3.125 + kWidestGap_m)[0], (Vec2{0, 3.125 + kWidestGap_m}));
  EXPECT_EQ(closed_park(2.5)[0], (Vec2{0, 2.5}));
  EXPECT_EQ(closed_park(3.5, map::LandCoverClass::kGrass)[0], (Vec2{0, 3.5}));
}

}  // namespace
}  // namespace citykiln::ground
