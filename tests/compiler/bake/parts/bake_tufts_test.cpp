#include "compiler/bake/parts/bake_tufts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/bake/bake.h"

namespace citykiln::bake {
namespace {

ground::LandCoverPolygon tuft_ground(std::int64_t id, map::LandCoverClass cover, const Box2& box) {
  return {{{OsmType::kWay, id}, 0},
          cover,
          static_cast<std::uint32_t>(box.width() * box.height()),
          {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// A park with a square in it.
scene::Scene park_with_square() {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {256, 256}};
  scene.header.tile_m = 256;
  scene::Chunk& chunk = scene.chunks.emplace_back();
  chunk.heights = {{-64, -64}, {64, 64}, 7, 7, {}, 0};
  chunk.heights.heights.assign(49, 0);
  chunk.surfaces = {tuft_ground(1, map::LandCoverClass::kPark, {{-48, -48}, {304, 304}}),
                    tuft_ground(2, map::LandCoverClass::kSquare, {{100, 100}, {140, 140}})};
  return scene;
}

std::size_t tufts_of(const BakedTile& tile) {
  std::size_t count = 0;
  for (const InstancedMesh& instanced : tile.instanced)
    if (instanced.name.starts_with("tuft_of_")) count += instanced.translations.size();
  return count;
}

std::size_t tufts_at(const scene::Scene& scene, double tolerance_m) {
  Report report;
  const double tolerances_m[] = {tolerance_m};
  return tufts_of(bake(scene.header, scene.chunks[0], tolerances_m, 1, report).front());
}

TEST(BakedTufts, AreOnLevelsUpToTwoCentimetresAlone) {
  const scene::Scene scene = park_with_square();
  EXPECT_GT(tufts_at(scene, 0.02), 400u);
  EXPECT_EQ(tufts_at(scene, 0.021), 0u);
  EXPECT_EQ(tufts_at(scene, 0.1), 0u);
}

TEST(BakedTufts, AreNotUnderSnow) {
  scene::Scene scene = park_with_square();
  scene.header.snow_line_m = -100;
  EXPECT_EQ(tufts_at(scene, 0.02), 0u);
}

TEST(BakedTufts, StandNearTheEye) {
  const scene::Scene scene = park_with_square();
  const View view{{90, 120, 1.7}, 600};
  std::size_t count = 0;
  for (const BakedTile& part : bake(scene.header, scene.chunks[0], levels_for(scene, view), 1)) {
    count += tufts_of(part);
    for (const InstancedMesh& instanced : part.instanced) {
      if (!instanced.name.starts_with("tuft_of_")) continue;
      for (const Float3& at : instanced.translations)
        EXPECT_LT(distance(in_plan(part.origin + widened(at)), {90, 120}), 32);
    }
  }
  EXPECT_GT(count, 10'000u);
  EXPECT_LT(count, 300'000u);
}

}  // namespace
}  // namespace citykiln::bake
