#include "compiler/scene/land_cover.h"

#include <gtest/gtest.h>

#include "compiler/ground/cover/land_cover_index.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::scene {
namespace {

roads::Road path(std::int64_t id, Polyline axis, Profile profile) {
  roads::Road road = roads::made_road(id, std::move(axis), 3, map::LandCoverClass::kFootPath);
  road.profile = std::move(profile);
  return road;
}

// A path that goes down, and one that follows the ground.
Chunk two_paths() {
  Chunk chunk;
  chunk.roads = {path(1, {{10, 10}, {90, 10}}, {{0, 5, 0}, {80, 1, 0}}), path(2, {{10, 50}, {90, 50}}, {})};
  return chunk;
}

void expect_first_alone_graded(const std::vector<ground::LandCoverPolygon>& surfaces) {
  EXPECT_GE(surfaces.size(), 2u);
  for (const ground::LandCoverPolygon& s : surfaces) EXPECT_EQ(s.is_graded, s.id.osm.id == 1) << s.id.osm.id;
}

TEST(LandCover, SaysWhatLiesOnAProfileAtEveryTolerance) {
  const Chunk chunk = two_paths();
  Header header;
  header.tile_m = 128;
  for (const double tolerance_m : {0.02, 12.5})
    expect_first_alone_graded(land_cover_of(header, chunk, tolerance_m).surfaces);
}

TEST(LandCover, JunctionsAreGradedWithAnyOfTheirArms) {
  std::vector roads{path(1, {{10, 10}, {50, 10}}, {}), path(2, {{50, 10}, {90, 10}}, {}),
                    path(3, {{50, 10}, {50, 90}}, {})};
  const std::vector<roads::Arm> arms{{0, 1, -1}, {1, 0, 1}, {2, 0, 1}};
  roads::Junction junction;
  junction.nodes = {{50, 10}};
  junction.cuts.resize(3);
  EXPECT_FALSE(junction_surface(junction, roads, arms).is_graded);
  roads[2].profile = {{0, 5, 0}, {80, 1, 0}};
  EXPECT_TRUE(junction_surface(junction, roads, arms).is_graded);
}

ground::LandCoverPolygon square_water(std::int64_t id, map::LandCoverClass surface, double from_m, double side_m) {
  const double to_m = from_m + side_m;
  return {.id = {{OsmType::kWay, id}, 0},
          .surface = surface,
          .area_m2 = static_cast<std::uint32_t>(side_m * side_m),
          .rings = {{{from_m, from_m}, {to_m, from_m}, {to_m, to_m}, {from_m, to_m}}}};
}

roads::Strip watercourse(std::int64_t id, map::LandCoverClass surface, double y_m) {
  roads::Strip stream;
  stream.id = {{OsmType::kWay, id}, 0};
  stream.surface = surface;
  stream.axis = {{0, y_m}, {100, y_m}};
  stream.left_m = stream.right_m = 3;
  return stream;
}

// The class on top at a place where a river, a stream and standing water are mapped.
map::LandCoverClass on_top(const std::vector<ground::LandCoverPolygon>& surfaces, Vec2 at) {
  const ground::LandCoverIndex index = ground::index_land_cover(surfaces, {{0, 0}, {100, 100}});
  const std::uint32_t top = ground::land_cover_at(index, at);
  return top == ground::kNoLandCover ? map::LandCoverClass::kUnknown : surfaces[top].surface;
}

// Rivers are mapped through lakes and streams through rivers, so that they connect.
TEST(LandCover, AWatercourseInMappedWaterHasTheLooksOfThatWater) {
  using enum map::LandCoverClass;
  for (const map::LandCoverClass standing : {kLake, kReservoir, kBasin, kPond, kDock, kPool})
    for (const map::LandCoverClass running : {kRiver, kStream}) {
      Chunk chunk;
      chunk.surfaces = {square_water(1, standing, 20, 60)};
      chunk.watercourses = {watercourse(2, running, 50)};
      const auto surfaces = coarse_land_cover(chunk);
      EXPECT_EQ(on_top(surfaces, {10, 50}), running);
      EXPECT_EQ(on_top(surfaces, {50, 50}), standing);
    }
}

TEST(LandCover, AStreamInARiverHasTheLooksOfTheRiver) {
  using enum map::LandCoverClass;
  Chunk chunk;
  chunk.surfaces = {square_water(1, kRiver, 20, 60)};
  chunk.watercourses = {watercourse(2, kStream, 50)};
  EXPECT_EQ(on_top(coarse_land_cover(chunk), {50, 50}), kRiver);
  EXPECT_EQ(on_top(coarse_land_cover(chunk), {10, 50}), kStream);
}

}  // namespace
}  // namespace citykiln::scene
