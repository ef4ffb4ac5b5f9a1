#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "compiler/contract/findings/report.h"
#include "compiler/invent/write/encode_heights.h"
#include "compiler/invent/write/world_place.h"
#include "compiler/invent/write/write_map.h"
#include "compiler/map/plane/plane.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "exporters/file.h"
#include "tests/scratch_folder.h"

namespace citykiln::invent {
namespace {

TEST(WorldPlace, IsTheInverseOfTheMapsPlane) {
  for (const LonLat middle : {LonLat{12.3, 48.7}, {-70, -33}, {0, 0}, {179, 75}}) {
    const WorldPlace place(middle);
    const map::Plane plane({middle.lon_deg, middle.lat_deg});
    for (const Vec2 p : {Vec2{0, 0}, {512, -512}, {-10000, 30000}, {40000, 20000}}) {
      const LonLat degrees = place.degrees_of(p);
      EXPECT_LT(distance(plane.forward({degrees.lon_deg, degrees.lat_deg}), p), 1e-6) << middle.lon_deg << " " << p.x;
    }
  }
}

TEST(WorldPlace, TheBoxLiesInsideTheSquare) {
  const WorldPlace place({12.3, 48.7});
  const map::Plane plane({12.3, 48.7});
  const auto [low, high] = place.box_inside(8192);
  for (const double lon : {low.lon * 1e-7, high.lon * 1e-7})
    for (const double lat : {low.lat * 1e-7, high.lat * 1e-7}) {
      const Vec2 p = plane.forward({lon, lat});
      EXPECT_LE(std::abs(p.x), 4096);
      EXPECT_LE(std::abs(p.y), 4096);
      EXPECT_GT(std::abs(p.x), 4080);
    }
}

TEST(EncodeHeights, AreReadBackWhereTheyWere) {
  Terrain terrain;
  terrain.side_m = 400, terrain.cells = 4;
  for (int i = 0; i < 25; ++i) terrain.heights_m.push_back(static_cast<float>(100 + i * 1.25));
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/heights.tif";
  ASSERT_TRUE(exporters::write_file(path, encode_heights(terrain, WorldPlace({12.3, 48.7}))));
  const auto raster = source::read_raster({.path = path}, nullptr);
  ASSERT_TRUE(raster) << to_string(raster.error());
  ASSERT_EQ(raster->columns, 5);
  ASSERT_EQ(raster->rows, 5);
  // row 0 is the northernmost
  EXPECT_EQ(raster->at(0, 0), terrain.heights_m[20]);
  EXPECT_EQ(raster->at(4, 4), terrain.heights_m[4]);
  EXPECT_NEAR(raster->spacing_m.x, 100, 0.01);
  // the middle of the square is the middle sample
  EXPECT_NEAR(raster->from_grid[0] + 2 * raster->from_grid[1], 0, 1e-9);
  EXPECT_NEAR(raster->from_grid[3] + 2 * raster->from_grid[5], 0, 1e-9);
}

InventedMap small_map() {
  InventedMap map;
  map.points.push_back({{5, 0}, {{"highway", "crossing"}}});
  map.lines.push_back({{{0, 0}, {5, 0}, {10, 0}}, {{"highway", "residential"}}});
  map.lines.push_back({{{5, 0}, {5, 10}}, {{"highway", "footway"}}});
  map.areas.push_back({{{{20, 20}, {40, 20}, {40, 40}, {20, 40}}, {{{25, 25}, {25, 35}, {35, 35}, {35, 25}}}},
                       {{"landuse", "meadow"}}});
  map.areas.push_back({{{{50, 50}, {60, 50}, {60, 60}}, {}}, {{"building", "yes"}}});
  return map;
}

TEST(WriteMap, IsReadBackWithSharedNodesAndHoles) {
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/map.osm.pbf";
  const auto counts = write_map(small_map(), WorldPlace({12.3, 48.7}), 256, path);
  ASSERT_TRUE(counts) << to_string(counts.error());
  // 3 + 1 of the lines, 8 of the meadow, 3 of the building
  EXPECT_EQ(counts->nodes, 15U);
  EXPECT_EQ(counts->ways, 5U);
  EXPECT_EQ(counts->relations, 1U);
  Report report;
  const auto osm = source::read_osm(path, 1, report);
  ASSERT_TRUE(osm) << to_string(osm.error());
  EXPECT_EQ(osm->areas.size(), 2U);
  const auto nodes = [&](const source::Way& way) { return osm->nodes_of(way); };
  ASSERT_GE(osm->ways.size(), 2U);
  EXPECT_EQ(nodes(osm->ways[0])[1].id, nodes(osm->ways[1])[0].id);
}

TEST(WriteMap, TheSameMapGivesTheSameBytes) {
  const ScratchFolder scratch;
  for (const char* name : {"/a.osm.pbf", "/b.osm.pbf"})
    ASSERT_TRUE(write_map(small_map(), WorldPlace({12.3, 48.7}), 256, scratch.path() + name));
  EXPECT_EQ(*exporters::read_file(scratch.path() + "/a.osm.pbf"), *exporters::read_file(scratch.path() + "/b.osm.pbf"));
}

TEST(WriteMap, AFolderThatIsMissingIsAnError) {
  const auto counts = write_map(small_map(), WorldPlace({12.3, 48.7}), 256, "/nowhere/map.osm.pbf");
  ASSERT_FALSE(counts);
  EXPECT_EQ(counts.error().where, "/nowhere/map.osm.pbf");
}

}  // namespace
}  // namespace citykiln::invent
