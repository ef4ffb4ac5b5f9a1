#include "compiler/verify/heights/measure_earthworks.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

using map::LandCoverClass;

constexpr double kTerrain_m = 100;

scene::Header header_of_one_tile() {
  scene::Header header;
  header.extent = {{0, 0}, {256, 256}};
  header.tile_m = 256;
  return header;
}

// Level terrain; a road along y = 100 with two heights.
scene::Chunk chunk_with_road(double from_m, double to_m) {
  scene::Chunk chunk;
  chunk.heights = {.min = {0, 0}, .step_m = {256, 256}, .columns = 2, .rows = 2, .heights = {}};
  chunk.heights.heights.assign(4, static_cast<std::int32_t>(kTerrain_m / map::kHeightQuantum_m));
  roads::Road road;
  road.id = {{OsmType::kWay, 1}, 0};
  road.axis = {{0, 100}, {200, 100}};
  road.surface = LandCoverClass::kResidentialRoad;
  road.profile = {{0, from_m, 0}, {200, to_m, 0}};
  chunk.roads.push_back(road);
  return chunk;
}

TEST(MeasureEarthworks, FindsTheDeepestCutAndTheHighestFillOfAWay) {
  const auto found = measure_earthworks(header_of_one_tile(), chunk_with_road(96, 107));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], (Earthwork{{OsmType::kWay, 1}, "road", 4, {0, 100}}));
  EXPECT_EQ(found[1], (Earthwork{{OsmType::kWay, 1}, "road", -7, {200, 100}}));
}

TEST(MeasureEarthworks, AreNoneOnTheTerrainAndNoneOutsideOfTheTile) {
  EXPECT_TRUE(measure_earthworks(header_of_one_tile(), chunk_with_road(kTerrain_m, kTerrain_m + 0.25)).empty());
  scene::Chunk chunk = chunk_with_road(90, 90);
  chunk.tile = {1, 0};
  scene::Header header = header_of_one_tile();
  header.extent.max.x = 512;
  EXPECT_TRUE(measure_earthworks(header, chunk).empty());
}

TEST(MeasureEarthworks, OverTheLimitsAreThoseDeeperThanTheirKindHasAsARule) {
  scene::Scene scene{header_of_one_tile(), {chunk_with_road(kTerrain_m - 14, kTerrain_m + 2)}};
  roads::Road path = scene.chunks[0].roads[0];
  path.id.osm.id = 2, path.surface = LandCoverClass::kSteps;
  path.profile = {{0, kTerrain_m - 4, 0}, {200, kTerrain_m + 6, 0}};
  scene.chunks[0].roads.push_back(path);
  const auto all = measure_earthworks(scene);
  EXPECT_EQ(all.size(), 4u);
  const auto over = over_their_limits(all);
  ASSERT_EQ(over.size(), 2u);
  EXPECT_EQ(over[0], (Earthwork{{OsmType::kWay, 1}, "road", 14, {0, 100}}));
  EXPECT_EQ(over[1], (Earthwork{{OsmType::kWay, 2}, "path", -6, {200, 100}}));
}

TEST(MeasureEarthworks, NameWatercoursesByTheirWidth) {
  scene::Chunk chunk = chunk_with_road(kTerrain_m, kTerrain_m);
  for (const double half_m : {0.5, 2.0, 6.0}) {
    roads::Strip water{{{OsmType::kWay, 2}, 0}, {{0, 50}, {100, 50}}, LandCoverClass::kRiver, half_m, half_m};
    water.profile = {{0, 95, 0}};
    chunk.watercourses.push_back(water);
  }
  const auto found = measure_earthworks(header_of_one_tile(), chunk);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].line, "ditch");
  EXPECT_EQ(found[1].line, "stream");
  EXPECT_EQ(found[2].line, "river");
  EXPECT_LT(earthwork_limit_m("ditch"), earthwork_limit_m("river"));
}

TEST(MeasureEarthworks, OfSeveralTilesAreOneCutAndOneFillForEachWay) {
  const OsmId way{OsmType::kWay, 1}, other{OsmType::kWay, 2};
  const auto all =
      combined({{way, "road", 2, {}}, {other, "road", 3, {}}, {way, "road", 4, {}}, {way, "road", -1, {}}});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].depth_m, 4);
  EXPECT_EQ(all[1].depth_m, 3);
  EXPECT_EQ(all[2].depth_m, -1);
}

}  // namespace
}  // namespace citykiln::verify
