#include "compiler/bake/far/bake_surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/far/far_land.h"
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
  EXPECT_EQ(tile->error_m, 33);
  EXPECT_EQ(tile->tile, kSurroundingsTile);
  int on_border = 0;
  for (const Primitive& primitive : tile->primitives)
    for (const Float3& offset : primitive.positions) {
      const Vec3 p = tile->origin + widened(offset);
      if (surroundings::away_m(scene.header.extent, in_plan(p)) > 0) continue;
      ++on_border;
      const double above_m = p.z - map::height_m_at(scene.chunks[0].heights, in_plan(p));
      EXPECT_LT(std::min(std::abs(above_m), std::abs(above_m + 12)), 0.01);
    }
  EXPECT_GT(on_border, 60);
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
