#include "compiler/bake/far/bake_surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/far/far_buildings.h"
#include "compiler/bake/far/far_land.h"
#include "compiler/bake/far/far_windows.h"
#include "compiler/bake/far/patchwork.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/grid_lines.h"

namespace citykiln::bake {
namespace {

using map::LandCoverClass;
using materials::Material;

const Box2 kRegion{{-128, -128}, {128, 128}};

ground::LandCoverPolygon land_cover_on(std::int64_t id, LandCoverClass cover, const Box2& box) {
  return {.id = {{OsmType::kWay, id}, 0},
          .surface = cover,
          .area_m2 = 100,
          .rings = {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// One tile on a slope to the east: woods in its west, a field in its east. Hills around.
scene::Scene slope() {
  scene::Scene scene;
  scene::Header& header = scene.header;
  header.origin = {1.5, 42.5}, header.extent = kRegion, header.tile_m = 256;
  header.sky.time = sky::moment_of(std::chrono::year(2026) / 6 / 21, 12 * 60);
  header.around = {.x_m = surroundings::lines_for(-128, 128, 256),
                   .y_m = surroundings::lines_for(-128, 128, 256),
                   .heights_m = {},
                   .covers = {},
                   .error_m = 33};
  for (const std::int32_t y : header.around.y_m)
    for (const std::int32_t x : header.around.x_m)
      header.around.heights_m.push_back(std::clamp(1000 + x / 10, 0, 3400) + (y > 20000 ? 2 : 0));
  header.around.covers.assign(header.around.heights_m.size(), surroundings::Cover::kLand);
  scene::Chunk chunk;
  chunk.tile = {0, 0};
  header.extent = {{0, 0}, {256, 256}}, header.around.x_m = surroundings::lines_for(0, 256, 256);
  header.around.y_m = header.around.x_m;
  chunk.heights = {.min = {-64, -64}, .step_m = {64, 64}, .columns = 7, .rows = 7, .heights = {}};
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) chunk.heights.heights.push_back((1000 + (i - 1) * 6) * 64);
  chunk.surfaces = {land_cover_on(1, LandCoverClass::kForest, {{-10, -10}, {128, 266}}),
                    land_cover_on(2, LandCoverClass::kMeadow, {{128, -10}, {266, 266}})};
  scene.chunks = {chunk};
  return scene;
}

TEST(BakeSurroundings, JoinsTheTerrainOfTheTile) {
  const scene::Scene scene = slope();
  const auto tile = bake_surroundings(scene);
  ASSERT_TRUE(tile);
  EXPECT_GE(tile->error_m, 33);
  EXPECT_EQ(tile->tile, kSurroundingsTile);
  int on_border = 0;
  for (const Primitive& primitive : tile->primitives)
    for (const Float3& offset : primitive.positions) {
      const Vec3 p = tile->origin + widened(offset);
      if (surroundings::away_m(scene.header.extent, in_plan(p)) > 0) continue;
      const double above_m = p.z - map::height_m_at(scene.chunks[0].heights, in_plan(p));
      const bool is_canopy = primitive.material == Material::kForestFloor && above_m > 1;
      if (is_canopy) continue;
      ++on_border;
      EXPECT_LT(std::min(std::abs(above_m), std::abs(above_m + 12)), 0.01);
    }
  EXPECT_GT(on_border, 60);
}

// Triangles of a layer.
std::size_t triangles_in(const BakedTile& tile, Layer layer) {
  std::size_t count = 0;
  for (const Primitive& primitive : tile.primitives)
    if (primitive.layer == layer) count += primitive.triangles.size();
  return count;
}

TEST(BakeSurroundings, BuildingsGoOnBeyondTheEdgeAsBoxes) {
  scene::Scene scene = slope();
  EXPECT_EQ(triangles_in(*bake_surroundings(scene), Layer::kBuildings), 0u);
  buildings::Building house{.id = {{OsmType::kWay, 7}, 0},
                            .footprint = {{{200, 100}, {212, 100}, {212, 108}, {200, 108}}, {}},
                            .bottom_m = 1000,
                            .floor_m = 1001,
                            .top_m = 1010};
  house.wall = Material::kPlaster, house.roof = Material::kRoofTile;
  house.roof_shape.height_m = 3;
  scene.chunks[0].buildings = {house};
  const auto tile = bake_surroundings(scene);
  EXPECT_GE(triangles_in(*tile, Layer::kBuildings), 10u);
  EXPECT_LE(triangles_in(*tile, Layer::kBuildings), kMostFarBuildings * 14);
  for (const Primitive& primitive : tile->primitives) {
    if (primitive.layer != Layer::kBuildings) continue;
    for (const Float3& offset : primitive.positions) {
      const double away_m = surroundings::away_m(scene.header.extent, in_plan(tile->origin + widened(offset)));
      EXPECT_GT(away_m, 0);
      EXPECT_LT(away_m, kFarBuildings_m + 500);
    }
  }
}

TEST(BakeSurroundings, WallsOfHousesHaveWindows) {
  scene::Scene scene = slope();
  EXPECT_TRUE(bake_surroundings(scene)->facade_atlas.colour.texels.empty());
  buildings::Building house{.id = {{OsmType::kWay, 7}, 0},
                            .footprint = {{{200, 100}, {212, 100}, {212, 108}, {200, 108}}, {}},
                            .bottom_m = 1000,
                            .floor_m = 1001,
                            .top_m = 1010};
  house.wall = Material::kPlaster, house.roof = Material::kRoofTile;
  scene.chunks[0].buildings = {house};
  const auto tile = bake_surroundings(scene);
  const impostor::Atlas atlas = far_windows();
  EXPECT_EQ(tile->facade_atlas, atlas);
  const auto walls = std::ranges::find_if(tile->primitives, [](const Primitive& primitive) {
    return primitive.colour_source == materials::ColourSource::kByAtlas;
  });
  ASSERT_NE(walls, tile->primitives.end());
  ASSERT_EQ(walls->uvs.size(), walls->positions.size());
  for (const Float2& uv : walls->uvs) {
    EXPECT_GE(std::min(uv[0], uv[1]), 0);
    EXPECT_LE(uv[0], atlas.colour.columns * atlas.colour.texel_m);
    EXPECT_LE(uv[1], atlas.colour.rows * atlas.colour.texel_m);
  }
}

TEST(FarWindows, WallsHaveWholeNumbersOfBaysAndStoreys) {
  const FarWindowPart part = window_part(12.5, 6.2, 6, 1.5);
  const auto& u = part.corners_m;
  EXPECT_DOUBLE_EQ(std::abs(u[1] - u[0]), 4 * kBay_m);
  EXPECT_DOUBLE_EQ(std::abs(u[2] - u[1]), 2 * kBay_m);
  EXPECT_DOUBLE_EQ(std::abs(u[3] - u[2]), 4 * kBay_m);
  EXPECT_DOUBLE_EQ(std::abs(u[0] - u[3]), 2 * kBay_m);
  EXPECT_DOUBLE_EQ(part.foot_m - part.eaves_m, 2 * kBay_m);
  EXPECT_NEAR((part.below_m - part.foot_m) / (part.foot_m - part.eaves_m), 0.25, 1e-9);
  // no more than the picture has
  const impostor::Atlas atlas = far_windows();
  const FarWindowPart large = window_part(500, 400, 90, 60);
  EXPECT_DOUBLE_EQ(large.corners_m[1], kMostBays * kBay_m);
  EXPECT_DOUBLE_EQ(large.eaves_m, 0);
  EXPECT_LT(large.below_m, atlas.colour.rows * atlas.colour.texel_m);
}

// Land that rises by 60 % towards the east, of unknown cover.
TEST(BakeSurroundings, SteepLandOfUnknownCoverIsScrubAndWood) {
  scene::Scene scene = slope();
  scene.chunks[0].surfaces.clear();
  surroundings::Surroundings& around = scene.header.around;
  for (std::size_t j = 0; j < around.rows(); ++j)
    for (std::size_t i = 0; i < around.columns(); ++i)
      around.heights_m[around.index(i, j)] = 600 + around.x_m[i] * 6 / 10;
  const scene::GroundLookup lookup(scene);
  const Patchwork patchwork(lookup, scene.header);
  int wild = 0, woods = 0;
  for (std::int32_t k = 0; k < 20; ++k) {
    const surroundings::Patch patch = patchwork.patch_of({320, 64 * k - 640, 32}, 64);
    const auto group = map::values_of(patch.cover).group;
    wild += group == map::LandCoverGroup::kForest || group == map::LandCoverGroup::kScrubland;
    woods += patch.raised_m > 0;
  }
  EXPECT_EQ(wild, 20);
  EXPECT_GT(woods, 2);
  EXPECT_LT(woods, 18);
}

TEST(BakeSurroundings, ARoadThatLeavesGoesOnInItsDirection) {
  scene::Scene scene = slope();
  roads::Road road{.id = {{OsmType::kWay, 9}, 0},
                   .axis = {{60, 128}, {300, 128}},
                   .surface = LandCoverClass::kPrimaryRoad,
                   .section = {}};
  scene.chunks[0].roads = {road};
  const auto tile = bake_surroundings(scene);
  ASSERT_GT(triangles_in(*tile, Layer::kRoads), 20u);
  double farthest_m = 0;
  for (const Primitive& primitive : tile->primitives) {
    if (primitive.layer != Layer::kRoads) continue;
    for (const Float3& offset : primitive.positions) {
      const Vec3 p = tile->origin + widened(offset);
      EXPECT_GT(p.x, 256);
      if (p.x < 356) {
        EXPECT_NEAR(p.y, 128, 8);
      }
      farthest_m = std::max(farthest_m, p.x - 256);
    }
  }
  EXPECT_GT(farthest_m, 800);
  EXPECT_LT(farthest_m, 1600);
}

TEST(BakeSurroundings, BesideTheEdgeItHasTheColourOfTheTilesGround) {
  const scene::Scene scene = slope();
  const scene::GroundLookup lookup(scene);
  const FarLand land = far_land_of(lookup, scene.header);
  const Patchwork patchwork(lookup, scene.header);
  const surroundings::Patch east = patchwork.patch_of({256, 96, 32}, 0), west = patchwork.patch_of({-32, 96, 32}, 0);
  EXPECT_EQ(east.cover, LandCoverClass::kMeadow);
  EXPECT_EQ(west.cover, LandCoverClass::kForest);
  EXPECT_GT(west.raised_m, 5);
  const Vec2 at{256, 112};
  const ground::LandCoverPolygon& meadow = scene.chunks[0].surfaces[1];
  const materials::Tint own =
      tint_of(surface_tint(meadow, Material::kMeadow, scene.header.seed, scene::month_of(scene.header)),
              place_tint(at, Material::kMeadow, scene.header.seed));
  const materials::Tint beside = tint_of(land, east, Material::kMeadow, at_height(at, 1000), {0, 0, 1}, 0);
  EXPECT_EQ(material_of(land, east, at_height(at, 1000), {0, 0, 1}, 0), Material::kMeadow);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(own[c], beside[c], 2) << c;
}

TEST(BakeSurroundings, IsTheSameWheneverItIsMade) {
  const scene::Scene scene = slope();
  EXPECT_EQ(bake_surroundings(scene), bake_surroundings(scene));
}

TEST(BakeSurroundings, IsNothingWithoutAGrid) {
  scene::Scene scene = slope();
  scene.header.around = {};
  EXPECT_FALSE(bake_surroundings(scene));
}

double green_to_red(const materials::SurfaceMaterial& look) {
  const auto& base = materials::values_of(look.material).base_colour;
  return static_cast<double>(base[1]) * look.tint[1] / (static_cast<double>(base[0]) * look.tint[0]);
}

double brightness(const materials::SurfaceMaterial& look) {
  const auto& base = materials::values_of(look.material).base_colour;
  return static_cast<double>(base[1]) * look.tint[1] / 255;
}

// Means over places: single ones are in patches.
template <typename Measure>
double mean_of(const FarLand& land, Vec2 middle, double height_m, Vec3 normal, Measure measure) {
  double sum = 0;
  for (int i = 0; i < 400; ++i)
    sum +=
        measure(far_material_of(land, at_height(middle + Vec2{(i % 20) * 211.0, (i / 20) * 197.0}, height_m), normal));
  return sum / 400;
}

TEST(FarLand, GoesOnAsAtTheEdgeThenTurnsToMeadowRockAndSnow) {
  scene::Scene scene = slope();
  const scene::GroundLookup lookup(scene);
  const FarLand land = far_land_of(lookup, scene.header);
  const Vec3 level{0, 0, 1};
  // beside the woods it is darker than beside the meadow
  const auto light = [&](Vec2 middle, double height_m) { return mean_of(land, middle, height_m, level, brightness); };
  EXPECT_LT(light({-4500, 0}, 1000), 0.8 * light({500, 0}, 1000));
  // above the tree line there are no woods, and higher up is rock
  EXPECT_GT(light({-4500, 0}, 2550), 1.2 * light({-4500, 0}, 1000));
  EXPECT_GT(mean_of(land, {-4500, 0}, 2300, level, green_to_red), 1.2);
  EXPECT_LT(mean_of(land, {-4500, 0}, 3100, level, green_to_red), 1.15);
  EXPECT_LT(mean_of(land, {-4500, 0}, 1000, unit(Vec3{2, 0, 1}), green_to_red), 1);
  scene.header.snow_line_m = 2800;
  EXPECT_EQ(far_material_of(land, {-4500, 0, 3000}, level).material, Material::kSnow);
  EXPECT_EQ(far_material_of(land, {-4500, 0, 2600}, level).material, Material::kScree);
}

}  // namespace
}  // namespace citykiln::bake
