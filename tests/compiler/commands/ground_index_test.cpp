#include "compiler/commands/ground_index.h"

#include <gtest/gtest.h>

#include "tests/compiler/commands/made_ground.h"

namespace citykiln::commands {
namespace {

TEST(GroundIndex, TellsTheHeightOfAPlaceAndWhatCoversIt) {
  const GroundIndex index = index_ground(made_ground(map::SurfaceClass::kGrass, {0, 8, 8, 0}), {});
  const auto place = lowest_ground_at(index, {16, 40});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->z_m, 12);
  EXPECT_EQ(place->feature, kGroundFeature);
}

TEST(GroundIndex, HasGroundOnItsEdgesAndNoneOutside) {
  const GroundIndex index = index_ground(made_ground(map::SurfaceClass::kGrass, {0, 0, 0, 0}), {});
  for (const Vec2 p : {Vec2{0, 0}, Vec2{64, 64}, Vec2{32, 32}, Vec2{64, 1}}) EXPECT_TRUE(lowest_ground_at(index, p));
  EXPECT_FALSE(lowest_ground_at(index, {65, 1}));
}

TEST(GroundIndex, OverlooksWhatLeavesTheGround) {
  const std::vector leaving = {kGroundFeature};
  const GroundIndex index = index_ground(made_ground(map::SurfaceClass::kGrass, {0, 0, 0, 0}), leaving);
  EXPECT_FALSE(lowest_ground_at(index, {32, 32}));
}

}  // namespace
}  // namespace citykiln::commands
