// Walls beside streets show the texture of their material.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/bake/bake.h"

namespace citykiln::bake {
namespace {

// Level land with one wall, baked.
BakedTile baked_wall(double length_m, double height_m, double tolerance_m) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {256, 256}};
  scene.header.tile_m = 256;
  scene::Chunk& chunk = scene.chunks.emplace_back();
  chunk.heights = {{-64, -64}, {64, 64}, 7, 7, {}, 0};
  chunk.heights.heights.assign(49, 0);
  chunk.barriers = {
      {{{OsmType::kWay, 1}, 0}, {{100, 100}, {100 + length_m, 100}}, map::BarrierKind::kWall, height_m, 0.25}};
  Report report;
  return bake(scene.header, chunk, tolerance_m, 1, report);
}

bool has_textured_prop(const BakedTile& tile) {
  return std::ranges::any_of(tile.primitives,
                             [](const Primitive& part) { return part.layer == Layer::kProps && !part.uvs.empty(); });
}

TEST(PlanarTexture, IsOnLargeFacesAtTenCentimetres) {
  EXPECT_TRUE(has_textured_prop(baked_wall(30, 2, 0.02)));
  EXPECT_TRUE(has_textured_prop(baked_wall(30, 2, 0.1)));
  EXPECT_FALSE(has_textured_prop(baked_wall(30, 2, 2.5)));
}

// Coordinates on ribs and posts would cost more bytes than they show.
TEST(PlanarTexture, IsOnSmallFacesOnlyWhereBumpsShow) {
  EXPECT_TRUE(has_textured_prop(baked_wall(0.5, 0.3, 0.02)));
  EXPECT_FALSE(has_textured_prop(baked_wall(0.5, 0.3, 0.1)));
}

}  // namespace
}  // namespace citykiln::bake
