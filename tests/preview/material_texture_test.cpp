#include "preview/scene/material_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/materials/texture_cache.h"
#include "preview/scene/world.h"
#include "tests/preview/near_colours.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;
using materials::Texture;
using Colour = std::array<double, 3>;

TEST(MaterialTexture, RepeatsBothWays) {
  const Texture bark = materials::texture_of(Material::kFurrowedBark, 0.05, 1);
  const MaterialTexture surface(bark);
  const double side = side_m(bark);
  for (const Vec2 at : {Vec2{0, 0}, Vec2{0.01, 7.99}, Vec2{3.3, 1.2}})
    for (const double across_m : {0.0, 0.3, 2.0}) {
      const Colour here = surface.colour({at, {}, across_m});
      expect_near(surface.colour({at + Vec2{side, 0}, {}, across_m}), here, 1e-9);
      expect_near(surface.colour({at + Vec2{-3 * side, 5 * side}, {}, across_m}), here, 1e-9);
    }
}

TEST(MaterialTexture, GoesOnSmoothlyOverItsSides) {
  const Texture grass = materials::texture_of(Material::kGrass, 0.05, 1);
  const MaterialTexture surface(grass);
  const double side = side_m(grass), step = 1e-6;
  for (double y = 0.1; y < side; y += 0.37) {
    expect_near(surface.colour({{side - step, y}, {}, 0}), surface.colour({{side + step, y}, {}, 0}), 1e-4);
    expect_near(surface.colour({{y, -step}, {}, 0}), surface.colour({{y, step}, {}, 0}), 1e-4);
  }
}

TEST(MaterialTexture, IsTheMaterialsColourFromAfar) {
  for (const Material material : {Material::kGrass, Material::kFarmland, Material::kRock, Material::kSea}) {
    const auto base = values_of(material).base_colour;
    const Texture texture = materials::texture_of(material, 0.02, 1);
    const MaterialTexture surface(texture);
    expect_near(surface.colour({{3, 4}, {}, 100}), {base[0], base[1], base[2]}, 1e-5);
  }
}

TEST(MaterialTexture, NormalsAreUnitVectorsAndUprightFromAfar) {
  const Texture rock = materials::texture_of(Material::kRock, 0.02, 1);
  const MaterialTexture surface(rock);
  double most = 0;
  for (double x = 0; x < 16; x += 0.3) {
    const Vec3 near = surface.normal({{x, 2 * x}, {}, 0});
    EXPECT_NEAR(length(near), 1, 1e-6);
    most = std::max(most, std::abs(near.x));
    EXPECT_GT(surface.normal({{x, 2 * x}, {}, 50}).z, 0.999);
  }
  EXPECT_GT(most, 0.2);
}

// A field of 32 m whose rows run along y, its texture turned so that u is y.
bake::BakedTile field_of_rows(Material material) {
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {floor({0, 0, 0}, {32, 32, 0}, material)};
  for (const bake::Float3& at : tile.primitives[0].positions) tile.primitives[0].uvs.push_back({at[1], at[0]});
  const Material shown[] = {material};
  tile.textures = materials::TextureCache(1).textures_of(shown, 0.05);
  return tile;
}

Hit seen_from_above(const bake::BakedTile& tile, double x, double y) {
  const World world(std::span(&tile, 1), {});
  const auto hit = world.first_hit({x, y, 1}, {0, 0, -1}, 1e-3);
  EXPECT_TRUE(hit);
  return hit.value_or(Hit{});
}

TEST(WorldTextures, ColourWhatHasPlacesOnThem) {
  const bake::BakedTile tile = field_of_rows(Material::kFarmland);
  const MaterialTexture surface(tile.textures[0]);
  for (const double x : {3.1, 9.7, 30.2}) {
    const Hit hit = seen_from_above(tile, x, 2 * x / 3);
    expect_near(hit.albedo, surface.colour({{2 * x / 3, x}, {}, 1e-3}), 1e-4);
  }
}

// u is north and v east: a slope that the texture gives along u leans north, one against v leans west.
TEST(WorldTextures, TurnTheirNormalsAsTheyLie) {
  const bake::BakedTile tile = field_of_rows(Material::kFarmland);
  const MaterialTexture surface(tile.textures[0]);
  for (const double x : {3.1, 9.7, 30.2}) {
    const Hit hit = seen_from_above(tile, x, 2 * x / 3);
    const Vec3 n = surface.normal({{2 * x / 3, x}, {}, 1e-3});
    EXPECT_NEAR(hit.shading_normal.y, n.x, 1e-3);
    EXPECT_NEAR(hit.shading_normal.x, -n.y, 1e-3);
    EXPECT_NEAR(hit.shading_normal.z, n.z, 1e-3);
  }
}

TEST(WorldTextures, LeaveWhatHasNoPlacesAlone) {
  bake::BakedTile tile = field_of_rows(Material::kFarmland);
  tile.primitives[0].uvs.clear();
  const auto base = values_of(Material::kFarmland).base_colour;
  expect_near(seen_from_above(tile, 5, 5).albedo, {base[0], base[1], base[2]}, 1e-6);
}

}  // namespace
}  // namespace citykiln::preview
