#include "compiler/verify/standing/measure_things.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

constexpr OsmId kBench{OsmType::kNode, 7};

// A bench at a place beside or on a road from x = 20 to x = 28, in a tile with its origin at 10, 0.
StandingThings bench_at(Vec2 at, bool is_in_way = false) {
  const Ring road = {{20, 0}, {28, 0}, {28, 64}, {20, 64}};
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kGroundFeature, 0}, map::LandCoverClass::kResidentialRoad, 512, {road}}};
  scene::Chunk chunk;
  chunk.things.push_back({.id = {kBench, 0}, .at = at, .is_in_way = is_in_way});
  bake::BakedTile tile;
  tile.origin = {10, 0, 0};
  tile.features = {kGroundFeature, kBench};
  bake::InstancedMesh benches;
  benches.translations = {{static_cast<float>(at.x - 10), static_cast<float>(at.y), 0}};
  benches.features = {1};
  tile.instanced.push_back(benches);
  return measure_things(tile, chunk, ground::index_land_cover(surfaces, kMadeBox));
}

TEST(MeasureThings, CountsThoseInACarriageway) {
  const StandingThings found = bench_at({24, 32});
  EXPECT_EQ(found.tested, 1u);
  EXPECT_EQ(found.conflicts, 1u);
  EXPECT_EQ(found.element, kBench);
  EXPECT_EQ(found.at, (Vec2{24, 32}));
}

TEST(MeasureThings, LeavesOutThoseBesideItAndThoseThatAreMappedInIt) {
  EXPECT_EQ(bench_at({30, 32}).tested, 1u);
  EXPECT_EQ(bench_at({30, 32}).conflicts, 0u);
  EXPECT_EQ(bench_at({24, 32}, true).tested, 0u);
}

}  // namespace
}  // namespace citykiln::verify
