#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/bake/bake.h"

namespace citykiln::bake {
namespace {

constexpr double kLevelTile_m = 1024, kLevelGround_m = 30;

buildings::Building house(std::int64_t id, Vec2 at, double height_m) {
  buildings::Building house;
  house.id = {{OsmType::kWay, id}, 0};
  house.footprint.outer = {at, at + Vec2{10, 0}, at + Vec2{10, 10}, at + Vec2{0, 10}};
  house.bottom_m = kLevelGround_m, house.top_m = kLevelGround_m + height_m;
  house.wall = house.roof = materials::Material::kConcrete;
  return house;
}

// Flat land with rows of houses, some of them low.
scene::Scene scene_of_house_rows() {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {kLevelTile_m, kLevelTile_m}};
  scene.header.tile_m = kLevelTile_m;
  scene::Chunk& chunk = scene.chunks.emplace_back();
  chunk.heights = {{-64, -64}, {64, 64}, 19, 19, {}, 0};
  chunk.heights.heights.assign(19 * 19, static_cast<std::int32_t>(kLevelGround_m / map::kHeightQuantum_m));
  for (std::int64_t i = 0; i < 100; ++i)
    chunk.buildings.push_back(
        house(i + 1, {20.0 + 100 * static_cast<double>(i / 10), 20.0 + 100 * static_cast<double>(i % 10)},
              i % 3 == 0 ? 0.5 : 6));
  return scene;
}

View near_the_corner() {
  View view{{5, 5, kLevelGround_m + 20}, 900};
  view.pixel_error = 1.5;
  return view;
}

struct Baked {
  scene::Scene scene = scene_of_house_rows();
  ViewLevels levels = levels_for(scene, near_the_corner());
  std::vector<BakedTile> parts = bake(scene.header, scene.chunks[0], levels, 1);
};

// The plan area of faces that look upwards.
double area_m2(const Primitive& primitive, const auto& is_counted) {
  double twice = 0;
  for (const auto& t : primitive.triangles) {
    const auto at = [&](std::size_t i) { return Vec2{primitive.positions[t[i]][0], primitive.positions[t[i]][1]}; };
    if (is_counted(primitive.features[t[0]])) twice += std::max(0.0, cross(at(1) - at(0), at(2) - at(0)));
  }
  return twice / 2;
}

TEST(BakeForView, PartsTogetherAreTheTileOnce) {
  const Baked baked;
  ASSERT_GE(baked.parts.size(), 4u);
  std::map<OsmId, double> roofs_m2;
  double ground_m2 = 0;
  for (const BakedTile& part : baked.parts)
    for (const Primitive& primitive : part.primitives)
      for (std::uint32_t f = 0; f < part.features.size(); ++f) {
        const double here_m2 = area_m2(primitive, [&](std::uint32_t feature) { return feature == f; });
        // footprints are ground as well
        (part.features[f] == OsmId{} ? ground_m2 : roofs_m2[part.features[f]]) += here_m2;
      }
  EXPECT_DOUBLE_EQ(ground_m2, kLevelTile_m * kLevelTile_m - 100 * 100);
  EXPECT_EQ(roofs_m2.size(), 100u);
  for (const auto& [id, area] : roofs_m2) {
    const bool is_high = (id.id - 1) % 3 != 0;
    if (is_high) {
      EXPECT_DOUBLE_EQ(area, 200) << id.id;
    }
    if (!is_high) {
      EXPECT_TRUE(area == 200 || area == 100) << id.id << ": " << area;
    }
  }
}

// A low house has its roof where its height is visible.
TEST(BakeForView, DropsLowHousesWhereTheyAreFarAlone) {
  const Baked baked;
  std::map<OsmId, double> nearest_m, areas_m2;
  for (const buildings::Building& b : baked.scene.chunks[0].buildings)
    if (b.top_m - b.bottom_m < 1) nearest_m[b.id.osm] = distance_m(bounds_of(b), baked.levels.view.eye);
  for (const BakedTile& part : baked.parts)
    for (const Primitive& primitive : part.primitives)
      for (const auto& house : nearest_m)
        areas_m2[house.first] +=
            area_m2(primitive, [&](std::uint32_t feature) { return part.features[feature] == house.first; });
  // half a metre is 1.5 pixels at 300 m; tolerances are powers of two
  EXPECT_FALSE(nearest_m.empty());
  for (const auto& [id, away_m] : nearest_m) {
    if (away_m < 300) {
      EXPECT_EQ(areas_m2[id], 200) << id.id << " at " << away_m;
    }
    if (away_m > 800) {
      EXPECT_EQ(areas_m2[id], 100) << id.id << " at " << away_m;
    }
  }
}

TEST(BakeForView, StatesAPixelErrorThatIsNotOverWhatWasAskedFor) {
  const Baked baked;
  double largest_px = 0;
  for (const BakedTile& part : baked.parts) {
    ASSERT_TRUE(part.viewpoint);
    EXPECT_EQ(part.viewpoint->eye, near_the_corner().eye);
    EXPECT_LE(part.viewpoint->pixel_error, near_the_corner().pixel_error);
    EXPECT_LE(part.error_m, part.tolerance_m);
    largest_px = std::max(largest_px, part.viewpoint->pixel_error);
  }
  EXPECT_GT(largest_px, 0) << "low houses are dropped, which is an error";
}

TEST(BakeForView, SameBytesForAnyNumberOfThreads) {
  const Baked baked;
  EXPECT_EQ(bake(baked.scene.header, baked.scene.chunks[0], baked.levels, 3), baked.parts);
}

}  // namespace
}  // namespace citykiln::bake
