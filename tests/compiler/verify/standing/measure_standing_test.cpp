#include "compiler/verify/standing/measure_standing.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

// A house of two storeys of 3 m on ground from 10 m in the west to 16.4 m in the east.
FloorMeasure standing_at(double floor_m, bool stands_on_ground = true, double error_m = 0) {
  buildings::Building house;
  house.id = {{OsmType::kWay, 2}, 0};
  house.footprint.outer = {{10, 10}, {20, 10}, {20, 20}, {10, 20}};
  house.bottom_m = floor_m - 6, house.floor_m = floor_m, house.top_m = floor_m + 6, house.levels = 2;
  house.stands_on_ground = stands_on_ground;
  scene::Chunk chunk;
  chunk.buildings = {house};
  const bake::BakedTile tile = made_ground(map::LandCoverClass::kGrass, {0, 6.4F, 6.4F, 0});
  return measure_standing(chunk, index_ground(tile), error_m);
}

TEST(MeasureStanding, FindsNothingOfAHouseOnItsSlope) {
  for (const double floor_m : {7.0, 11.0, 12.0, 14.5}) {
    const FloorMeasure standing = standing_at(floor_m);
    EXPECT_EQ(standing.buildings, 1u);
    EXPECT_TRUE(standing.off.empty()) << floor_m;
  }
}

TEST(MeasureStanding, FindsAFloorMoreThanAStoreyAboveTheGroundOnAllSides) {
  const FloorMeasure standing = standing_at(15.5);
  ASSERT_EQ(standing.off.size(), 1u);
  EXPECT_NEAR(standing.off[0].off_m, 3.5, 1e-5);
  EXPECT_TRUE(standing_at(15.5, true, 1).off.empty());
}

TEST(MeasureStanding, FindsAHouseBelowTheGround) {
  const FloorMeasure standing = standing_at(4);
  ASSERT_EQ(standing.off.size(), 1u);
  EXPECT_NEAR(standing.off[0].off_m, -1, 1e-5);
}

TEST(MeasureStanding, SkipsWhatIsLifted) { EXPECT_EQ(standing_at(30, false).buildings, 0u); }

}  // namespace
}  // namespace citykiln::verify
