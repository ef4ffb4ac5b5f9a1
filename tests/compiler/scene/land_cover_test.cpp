#include "compiler/scene/land_cover.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace citykiln::scene
