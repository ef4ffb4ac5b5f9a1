#include "compiler/verify/ground/ground_index.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

TEST(GroundIndex, FindsHeightAndFeatureOfAPlace) {
  const GroundIndex index = index_ground(made_ground(map::LandCoverClass::kGrass, {0, 8, 8, 0}));
  const auto places = ground_at(index, {16, 40});
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].z_m, 12);
  EXPECT_EQ(places[0].feature, kGroundFeature);
}

TEST(GroundIndex, HasGroundOnItsEdgesAndNoneOutside) {
  const GroundIndex index = index_ground(made_ground(map::LandCoverClass::kGrass, {0, 0, 0, 0}));
  for (const Vec2 p : {Vec2{0, 0}, Vec2{64, 64}, Vec2{32, 32}, Vec2{64, 1}}) EXPECT_FALSE(ground_at(index, p).empty());
  EXPECT_TRUE(ground_at(index, {65, 1}).empty());
  // what the plane's grid moves borders by
  EXPECT_FALSE(ground_at(index, {64 + 0x1p-10, 1}).empty());
  EXPECT_TRUE(ground_at(index, {64 + 0x1p-7, 1}).empty());
}

TEST(GroundIndex, FindsBothSidesOfAStep) {
  bake::BakedTile tile = made_ground(map::LandCoverClass::kGrass, {0, 0, 0, 0});
  bake::Primitive& ground = tile.primitives[0];
  // the second half lies three metres lower
  ground.positions.insert(ground.positions.end(), {{0, 0, -3}, {64, 64, -3}, {0, 64, -3}});
  ground.features.assign(7, 1);
  ground.triangles = {{0, 1, 2}, {4, 5, 6}};
  const auto places = ground_at(index_ground(tile), {32, 32});
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].z_m, 7);
  EXPECT_EQ(places[1].z_m, 10);
}

TEST(GroundIndex, SkipsObjectsOffTheGround) {
  bake::BakedTile tile = made_ground(map::LandCoverClass::kGrass, {0, 0, 0, 0});
  tile.primitives[0].layer = bake::Layer::kProps;
  EXPECT_TRUE(ground_at(index_ground(tile), {32, 32}).empty());
}

}  // namespace
}  // namespace citykiln::verify
