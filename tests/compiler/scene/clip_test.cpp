#include "compiler/scene/clip.h"

#include <gtest/gtest.h>

#include "compiler/scene/scene.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::scene {
namespace {

// A square with a hole.
const Clip kFrame = {{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{{40, 40}, {40, 60}, {60, 60}, {60, 40}}}}};
constexpr Box2 kAround{{-50, -50}, {150, 150}};

TEST(Clip, HasPlacesInsideButNotInItsHole) {
  const ClipTest test(kFrame, kAround);
  EXPECT_TRUE(test.is_inside({20, 20}));
  EXPECT_FALSE(test.is_inside({50, 50}));
  EXPECT_FALSE(test.is_inside({120, 50}));
  EXPECT_TRUE(ClipTest({}, kAround).is_inside({120, 50})) << "nothing is clipped";
}

TEST(Clip, CoversTheLandBeyondOnTopOfAllOthers) {
  const ground::LandCoverPolygon beyond = beyond_clip(kFrame, kAround);
  EXPECT_EQ(ground::winding_number(beyond, {20, 20}), 0);
  EXPECT_EQ(ground::winding_number(beyond, {50, 50}), 1);
  EXPECT_EQ(ground::winding_number(beyond, {120, 50}), 1);
  const ground::LandCoverPolygon building{.id = {}, .surface = map::LandCoverClass::kBuilding, .rings = {}};
  EXPECT_TRUE(ground::covers(beyond, building));
  EXPECT_TRUE(beyond_clip({}, kAround).rings.empty());
}

TEST(Clip, TouchesBoxesWithGroundInside) {
  EXPECT_TRUE(touches_clip(kFrame, {{-10, -10}, {10, 10}}));
  EXPECT_FALSE(touches_clip(kFrame, {{-10, -10}, {0, 0}})) << "a corner has no ground";
  EXPECT_FALSE(touches_clip(kFrame, {{42, 42}, {58, 58}})) << "in the hole";
  EXPECT_TRUE(touches_clip(kFrame, {{-10, -10}, {200, 200}}));
  EXPECT_TRUE(touches_clip(kFrame, {{10, 10}, {20, 20}})) << "wholly inside";
  EXPECT_TRUE(touches_clip({}, {{0, 0}, {1, 1}}));
}

// Four tiles of 256 m in a row, of which the clip touches the second and the third.
Header header_of_row() {
  Header header;
  header.extent = {{0, 0}, {1024, 256}}, header.tile_m = 256;
  header.clip = {{{{300, 50}, {700, 50}, {700, 200}, {300, 200}}, {}}};
  return header;
}

structures::Span bridge_along(Polyline axis) {
  return {roads::made_road(1, std::move(axis), 3, map::LandCoverClass::kResidentialRoad, 0, 0)};
}

TEST(Clip, ATileWithGroundBakesABridgeThatBeginsBeyondIt) {
  const Header header = header_of_row();
  EXPECT_EQ(baking_tile(header, bridge_along({{350, 100}, {900, 100}})), (TileKey{1, 0})) << "it begins inside";
  EXPECT_EQ(baking_tile(header, bridge_along({{100, 100}, {600, 100}})), (TileKey{1, 0}));
  EXPECT_EQ(baking_tile(header, bridge_along({{1000, 100}, {600, 100}})), (TileKey{2, 0}));
  EXPECT_EQ(baking_tile(header, bridge_along({{100, 100}, {200, 100}})), (TileKey{0, 0})) << "no part is inside";
  Header whole = header;
  whole.clip.clear();
  EXPECT_EQ(baking_tile(whole, bridge_along({{100, 100}, {600, 100}})), (TileKey{0, 0}));
}

TEST(Clip, ATileWithGroundBakesABuildingWhoseMiddleLiesBeyondIt) {
  const Box2 box{{200, 100}, {302, 150}};
  EXPECT_EQ(baking_tile(header_of_row(), box.centre(), box), (TileKey{1, 0}));
}

}  // namespace
}  // namespace citykiln::scene
