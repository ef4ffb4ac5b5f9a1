#include "compiler/bake/far/fade_roads.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::bake {
namespace {

Primitive primitive_with(Layer layer, materials::Material material) {
  Primitive p{.material = material, .positions = {}, .normals = {}, .colours = {}, .features = {}, .triangles = {}};
  p.layer = layer;
  return p;
}

void add_square(Primitive& p, float x, float y, float side, std::uint8_t grey) {
  const auto first = static_cast<std::uint32_t>(p.positions.size());
  for (const Float3& at :
       {Float3{x, y, 0}, Float3{x + side, y, 0}, Float3{x + side, y + side, 0}, Float3{x, y + side, 0}}) {
    p.positions.push_back(at), p.normals.push_back({0, 0, 1});
    p.colours.push_back({grey, grey, grey, 255}), p.features.push_back(1);
  }
  p.triangles.push_back({first, first + 1, first + 2}), p.triangles.push_back({first, first + 2, first + 3});
}

// 40 × 20 squares of 4 m: meadow, a road of one square's width along y = 8, and a paved square 40 m wide.
BakedTile crossing() {
  Primitive meadow = primitive_with(Layer::kGround, materials::Material::kGrass);
  Primitive road = primitive_with(Layer::kRoads, materials::Material::kAsphalt);
  for (int column = 0; column < 40; ++column)
    for (int row = 0; row < 20; ++row) {
      const bool is_paved = row == 2 || (column >= 20 && column < 30 && row >= 6 && row < 16);
      add_square(is_paved ? road : meadow, static_cast<float>(column * 4), static_cast<float>(row * 4), 4,
                 is_paved ? 100 : 200);
    }
  return {.tile = {0, 0},
          .origin = {0, 0, 0},
          .tolerance_m = 1,
          .error_m = 1,
          .features = {OsmId{}, {OsmType::kWay, 7}},
          .primitives = {meadow, road}};
}

TEST(FadeRoads, GivesNarrowRoadsToTheGroundBesideThemAndKeepsWideSquares) {
  BakedTile tile = crossing();
  fade_roads(tile, 6);
  ASSERT_EQ(tile.primitives.size(), 2u);
  const Primitive &meadow = tile.primitives[0], &road = tile.primitives[1];
  EXPECT_EQ(meadow.triangles.size() + road.triangles.size(), 40u * 20 * 2);
  EXPECT_EQ(std::ranges::count(meadow.colours, materials::Tint{200, 200, 200, 255}),
            static_cast<std::ptrdiff_t>(meadow.colours.size()));
  // what is left of the square is its middle
  EXPECT_GE(road.triangles.size(), 8u * 8 * 2);
  for (const auto& t : road.triangles)
    for (const std::uint32_t v : t) {
      EXPECT_GE(road.positions[v][0], 80);
      EXPECT_LE(road.positions[v][0], 120);
    }
  EXPECT_GT(tile.error_m, 1 + 2);
  EXPECT_LE(tile.error_m, 1 + 6);
}

TEST(FadeRoads, KeepsRoadsWiderThanTheTolerance) {
  BakedTile tile = crossing();
  fade_roads(tile, 1);
  EXPECT_EQ(tile.primitives[1].triangles.size(), crossing().primitives[1].triangles.size());
  EXPECT_EQ(tile.error_m, 1);
}

}  // namespace
}  // namespace citykiln::bake
