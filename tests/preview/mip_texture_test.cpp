#include "preview/scene/mip_texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "compiler/materials/material.h"
#include "preview/scene/world.h"
#include "tests/preview/near_colours.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;
using materials::TextureImage;
using Colour = std::array<double, 3>;

constexpr double kMipTexel_m = 0.25;

TextureImage speckled(std::uint32_t columns, std::uint32_t rows) {
  std::mt19937 dice(columns + rows);
  TextureImage sheet{kMipTexel_m, columns, rows, {}};
  const auto byte = [&] { return static_cast<std::uint8_t>(dice()); };
  for (std::uint32_t i = 0; i < columns * rows; ++i) sheet.texels.push_back({byte(), byte(), byte()});
  return sheet;
}

Colour linear(const TextureImage::Texel& texel) {
  return {materials::linear_of_srgb(texel[0]), materials::linear_of_srgb(texel[1]),
          materials::linear_of_srgb(texel[2])};
}

Colour mean_colour_of(const TextureImage& sheet) {
  Colour sum{};
  for (const TextureImage::Texel& texel : sheet.texels)
    for (int c = 0; c < 3; ++c) sum[c] += linear(texel)[c] / static_cast<double>(sheet.texels.size());
  return sum;
}

Vec2 middle(std::uint32_t column, std::uint32_t row) {
  return {(column + 0.5) * kMipTexel_m, (row + 0.5) * kMipTexel_m};
}

TEST(MipTexture, ShowsEachTexelInItsMiddle) {
  const TextureImage sheet = speckled(7, 5);
  const MipTexture texture(sheet);
  for (std::uint32_t row = 0; row < 5; ++row)
    for (std::uint32_t column = 0; column < 7; ++column)
      expect_near(texture.mean({middle(column, row), {}, 0}), linear(sheet.texels[row * 7 + column]));
}

TEST(MipTexture, IsLinearBetweenMiddles) {
  const TextureImage sheet = speckled(7, 5);
  const MipTexture texture(sheet);
  const Colour left = linear(sheet.texels[2 * 7 + 3]), right = linear(sheet.texels[2 * 7 + 4]);
  const Colour between = texture.mean({middle(3, 2) + Vec2{kMipTexel_m / 4, 0}, {}, 0});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(between[c], 0.75 * left[c] + 0.25 * right[c], 1e-6);
}

TEST(MipTexture, EndsAcrossAndRepeatsAlong) {
  const TextureImage sheet = speckled(7, 5);
  const MipTexture texture(sheet);
  const double period_m = 5 * kMipTexel_m;
  for (const double across_m : {0.0, 0.4}) {
    expect_near(texture.mean({{-3, 0.3}, {}, across_m}), texture.mean({{0, 0.3}, {}, across_m}));
    expect_near(texture.mean({{50, 0.3}, {}, across_m}), texture.mean({{7 * kMipTexel_m, 0.3}, {}, across_m}));
    for (const double turns : {-2.0, -1.0, 1.0, 4000.0})
      expect_near(texture.mean({{0.6, 0.3 + turns * period_m}, {}, across_m}),
                  texture.mean({{0.6, 0.3}, {}, across_m}));
  }
  // the seam is no edge: the last row's neighbour is the first
  const Colour last = linear(sheet.texels[4 * 7 + 3]), first = linear(sheet.texels[3]);
  const Colour seam = texture.mean({{middle(3, 0).x, 0}, {}, 0});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seam[c], (last[c] + first[c]) / 2, 1e-6);
}

TEST(MipTexture, AWidePatchIsTheMeanOfTheWhole) {
  const std::pair<int, int> sizes[] = {{1, 1},   {2, 2},    {3, 3},     {5, 5},  {7, 11},
                                       {64, 64}, {100, 37}, {129, 255}, {1, 300}};
  for (const auto& [columns, rows] : sizes) {
    const TextureImage sheet = speckled(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    const MipTexture texture(sheet);
    expect_near(texture.mean({{0.3, 0.7}, {}, 1e4}), mean_colour_of(sheet), 1e-5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_near(texture.mean({{nan, 0.7}, {}, 0}), mean_colour_of(sheet), 1e-5);
    expect_near(texture.mean({{0, 0.7}, {nan, 0}, 0}), mean_colour_of(sheet), 1e-5);
    expect_near(texture.mean({{0, 0.7}, {}, nan}), mean_colour_of(sheet), 1e-5);
  }
}

// White left half: a footprint drawn out along v keeps the edge, one drawn out along u mixes it.
TEST(MipTexture, ALongPatchMixesAlongItself) {
  TextureImage sheet{kMipTexel_m, 64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i)
    sheet.texels.push_back(i % 64 < 32 ? TextureImage::Texel{255, 255, 255} : TextureImage::Texel{});
  const MipTexture texture(sheet);
  const Vec2 white{31 * kMipTexel_m, 3};
  EXPECT_NEAR(texture.mean({white, {0, 2}, kMipTexel_m})[0], 1, 1e-6);
  EXPECT_NEAR(texture.mean({white, {2, 0}, kMipTexel_m})[0], 0.56, 0.05);
}

// Random pictures of 6 by 4 texels at odd places of a sheet, as on atlases: its size and what is around do not matter.
TEST(MipTexture, APartLooksTheSameAmongOtherNeighbours) {
  const TextureImage small = speckled(10, 8);
  TextureImage large = speckled(64, 32);
  constexpr std::uint32_t kRight = 40, kDown = 18;
  // with its frame, which begins at an even texel
  for (std::uint32_t row = 0; row < 6; ++row)
    for (std::uint32_t column = 0; column < 8; ++column)
      large.texels[(row + kDown) * 64 + column + kRight] = small.texels[row * 10 + column];
  const MipTexture here(small, TexelMeaning::kColours, WrapMode::kClamp, 2),
      there(large, TexelMeaning::kColours, WrapMode::kClamp, 2);
  const TexelRectangle part{1, 1, 6, 4}, moved{kRight + 1, kDown + 1, kRight + 6, kDown + 4};
  const Vec2 by{kRight * kMipTexel_m, kDown * kMipTexel_m};
  for (const double x_px : {-20.0, 1.0, 3.3, 7.0, 30.0})
    for (const double y_px : {-9.0, 1.0, 2.8, 5.0, 12.0})
      for (const Vec2 along : {Vec2{}, Vec2{3, 0.4}, Vec2{-0.1, 0.6}})
        for (const double across_m : {0.0, 1.3 * kMipTexel_m, 9 * kMipTexel_m})
          for (const bool is_rough : {false, true}) {
            const Vec2 at{x_px * kMipTexel_m, y_px * kMipTexel_m};
            expect_near(there.mean({at + by, along, across_m, is_rough}, moved),
                        here.mean({at, along, across_m, is_rough}, part), 1e-9);
          }
  // beyond an edge the outermost texel goes on
  expect_near(here.mean({middle(40, 2), {}, 0}, part), linear(small.texels[2 * 10 + 6]));
  expect_near(here.mean({middle(3, 40), {}, 0}, part), linear(small.texels[4 * 10 + 3]));
}

// ---- seen in a world -----------------------------------------------------------------------------------------------

// 64 m by 64 m of road that lies east and north of the tile's origin; u goes east and v north, from 100 on.
bake::Primitive marked_road() {
  bake::Primitive road = floor({0, 0, 0}, {64, 64, 0}, Material::kAsphalt);
  for (const bake::Float3& at : road.positions) road.uvs.push_back({at[0], 100 + at[1]});
  road.colour_source = materials::ColourSource::kByMarkingAtlas;
  return road;
}

// Squares of 2 m in four rows and four columns, no two alike.
TextureImage squares() {
  TextureImage sheet{kMipTexel_m, 32, 32, {}};
  for (std::uint32_t i = 0; i < 32 * 32; ++i)
    sheet.texels.push_back({static_cast<std::uint8_t>(i % 32 / 8 * 80), static_cast<std::uint8_t>(i / 32 / 8 * 80), 9});
  return sheet;
}

TEST(MarkingAtlasOnTheGround, IsSeenAtItsPlaceOrientationAndScale) {
  bake::BakedTile ground = tile({1000, 2000, 50}, {marked_road()});
  ground.marking_atlas = squares();
  const std::vector tiles = {ground};
  const World world(tiles, {1003, 2004, 60});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      // the atlas is 8 m wide and long: v = 100 is 12.5 repetitions
      const Vec3 above{1000 + 2.0 * column + 1, 2000 + 2.0 * ((row + 2) % 4) + 1, 60};
      const auto hit = world.first_hit(above - world.origin(), {0, 0, -1}, 0);
      ASSERT_TRUE(hit);
      const TextureImage::Texel texel = {static_cast<std::uint8_t>(80 * column), static_cast<std::uint8_t>(80 * row),
                                         9};
      expect_near(hit->albedo, linear(texel));
      EXPECT_EQ(hit->material, Material::kAsphalt);
    }
}

TEST(MarkingAtlasOnTheGround, IsTintedByTheCorners) {
  bake::BakedTile ground = tile({0, 0, 0}, {marked_road()});
  for (materials::Tint& tint : ground.primitives[0].colours) tint = {51, 102, 255, 255};
  ground.marking_atlas = TextureImage{1, 1, 1, {{200, 200, 200}}};
  const std::vector tiles = {ground};
  const auto hit = World(tiles, {}).first_hit({10, 10, 5}, {0, 0, -1});
  ASSERT_TRUE(hit);
  const double white = materials::linear_of_srgb(200);
  expect_near(hit->albedo, {white * 0.2, white * 0.4, white});
}

TEST(MarkingAtlasOnTheGround, FarAwayItIsItsMean) {
  bake::BakedTile ground = tile({0, 0, 0}, {marked_road()});
  ground.marking_atlas = squares();
  const std::vector tiles = {ground};
  const World world(tiles, {});
  const Vec3 road{20.7, 30.4, 0}, steep{20.7, 30.4, 4000}, flat{20.7, -3000, 30};
  for (const Vec3& eye : {steep, flat}) {
    const auto hit = world.first_hit(eye, unit(road - eye), eye.z == 30 ? 0.002 : 0.01);
    ASSERT_TRUE(hit);
    // across a flat view some of what lies across stays
    EXPECT_NEAR(hit->albedo[1], mean_colour_of(ground.marking_atlas)[1], 0.03);
  }
}

// Columns of colour along v, seen flat along v: they stay apart, though a pixel covers many metres of road.
TEST(MarkingAtlasOnTheGround, SeenFlatItStaysSharpAcross) {
  bake::BakedTile ground = tile({0, 0, 0}, {marked_road()});
  ground.marking_atlas = TextureImage{kMipTexel_m, 32, 4, {}};
  for (int i = 0; i < 32 * 4; ++i)
    ground.marking_atlas.texels.push_back(i % 32 < 8 ? TextureImage::Texel{255, 255, 255} : TextureImage::Texel{});
  const std::vector tiles = {ground};
  const World world(tiles, {});
  const auto seen = [&](double x) {
    const Vec3 eye{x, -20, 1.5};
    return world.first_hit(eye, unit(Vec3{x, 30, 0} - eye), 0.002)->albedo[0];
  };
  EXPECT_NEAR(seen(1), 1, 1e-6);
  EXPECT_NEAR(seen(3), 0, 1e-6);
}

TEST(MarkingAtlasOnTheGround, InstancesShowTheAtlasOfTheirTile) {
  const std::vector<bake::Primitive> shape = {marked_road()};
  const auto stands = [&](Vec3 origin, std::uint8_t grey) {
    bake::BakedTile at = tile(origin, {});
    at.instanced = {{"Road", shape, {{0, 0, 0}}, {{0, 0, 0, 1}}, {0.5f}, {0}}};
    at.marking_atlas = TextureImage{1, 1, 1, {{grey, grey, grey}}};
    return at;
  };
  const std::vector tiles = {stands({0, 0, 0}, 200), stands({100, 0, 0}, 90), stands({200, 0, 0}, 200)};
  const World world(tiles, {});
  for (const bake::BakedTile& one : tiles) {
    const auto hit = world.first_hit(one.origin + Vec3{5, 5, 5}, {0, 0, -1});
    ASSERT_TRUE(hit);
    expect_near(hit->albedo, linear(one.marking_atlas.texels[0]));
  }
}

TEST(MarkingAtlasOnTheGround, OtherRoadsKeepTheirMaterial) {
  bake::Primitive plain = marked_road();
  plain.colour_source = materials::ColourSource::kByMaterial;
  bake::BakedTile ground = tile({0, 0, 0}, {plain});
  ground.marking_atlas = squares();
  const std::vector tiles = {ground};
  const auto hit = World(tiles, {}).first_hit({10, 10, 5}, {0, 0, -1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->albedo[0], materials::values_of(Material::kAsphalt).base_colour[0], 1e-6);
}

}  // namespace
}  // namespace citykiln::preview
