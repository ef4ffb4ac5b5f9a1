#include "compiler/commands/view/view_options.h"

#include <gtest/gtest.h>

#include "compiler/commands/view/ground_height.h"

namespace citykiln::commands {
namespace {

std::optional<GivenPoint> point_in(const std::string& text) {
  std::optional<GivenPoint> point;
  return store_point(point)(text) ? point : std::nullopt;
}

/// A square of ground at 7 m about the origin of a tile at 100,200, and a roof above it.
bake::BakedTile square_tile() {
  bake::BakedTile tile{.tile = {}, .origin = {100, 200, 3}};
  const auto square = [](float z, bake::Layer layer) {
    return bake::Primitive{.positions = {{-5, -5, z}, {5, -5, z}, {5, 5, z}, {-5, 5, z}},
                           .normals = {},
                           .colours = {},
                           .features = {},
                           .triangles = {{0, 1, 2}, {0, 2, 3}},
                           .layer = layer};
  };
  tile.primitives = {square(4, bake::Layer::kGround), square(2, bake::Layer::kWater),
                     square(9, bake::Layer::kBuildings)};
  return tile;
}

TEST(ViewOptions, HeightsWithAPlusAreAboveTheGround) {
  const std::optional<GivenPoint> above = point_in("1,-2,+3.5"), absolute = point_in("1,-2,3.5");
  ASSERT_TRUE(above && absolute);
  EXPECT_TRUE(above->is_above_ground);
  EXPECT_FALSE(absolute->is_above_ground);
  EXPECT_EQ(above->at, (Vec3{1, -2, 3.5}));
  for (const char* wrong : {"1,2", "1,+2,3", "1,2,++3", "1,2,+", "a,2,+3"}) EXPECT_FALSE(point_in(wrong)) << wrong;
}

TEST(ViewOptions, TheGroundIsTheHighestFaceOfGroundRoadsOrWater) {
  const std::vector tiles = {square_tile()};
  EXPECT_EQ(ground_height_m(tiles, {101, 203}), 7);
  EXPECT_EQ(ground_height_m(tiles, {105, 205}), 7) << "on the border";
  EXPECT_EQ(ground_height_m(tiles, {105.1, 205}), std::nullopt);
}

TEST(ViewOptions, PointsAboveTheGroundNeedGround) {
  const std::vector tiles = {square_tile()};
  const GroundHeight ground_m = [&](Vec2 p) { return ground_height_m(tiles, p); };
  const auto found = point_of(point_in("101,203,+2"), std::nullopt, std::nullopt, ground_m);
  ASSERT_TRUE(found);
  EXPECT_EQ(**found, (Vec3{101, 203, 9}));
  EXPECT_FALSE(point_of(point_in("900,203,+2"), std::nullopt, std::nullopt, ground_m));
  EXPECT_FALSE(point_of(std::nullopt, point_in("7,43,2"), std::nullopt, ground_m)) << "no header";
}

}  // namespace
}  // namespace citykiln::commands
