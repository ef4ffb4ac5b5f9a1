#include "compiler/verify/heights/measure_lines.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

roads::Road sloping_road(std::int64_t id, Polyline axis, double from_m, double to_m) {
  roads::Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.profile = {{0, from_m, 0}, {length_m(axis), to_m, 0}};
  road.axis = std::move(axis);
  return road;
}

scene::Scene scene_of_chunk(scene::Chunk chunk) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {1024, 1024}};
  scene.chunks = {std::move(chunk)};
  return scene;
}

TEST(MeasureGrades, CountsLengthOverTheLimitOfTheClass) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 8}, {100, 8}}, 0, 10), sloping_road(2, {{0, 16}, {100, 16}}, 0, 30)};
  const Grades grades = measure_grades(scene_of_chunk(chunk).header, chunk);
  EXPECT_EQ(grades.length_m, 200);
  EXPECT_EQ(grades.over_m, 100);
}

TEST(MeasureGrades, CountsWhatLiesInTheTile) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{-100, 8}, {0, 8}, {100, 8}}, 0, 60)};
  const Grades grades = measure_grades(scene_of_chunk(chunk).header, chunk);
  EXPECT_EQ(grades.length_m, 100);
  EXPECT_EQ(grades.over_m, 100);
}

TEST(MeasureJumps, FindsRoadsThatMeetAtDifferentHeights) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 0}, {100, 0}}, 0, 10), sloping_road(2, {{100, 0}, {200, 0}}, 10, 0)};
  EXPECT_EQ(measure_jumps(scene_of_chunk(chunk)).largest_m, 0);
  chunk.roads[1].profile[0].z_m = 10.5;
  const Jumps jumps = measure_jumps(scene_of_chunk(chunk));
  EXPECT_EQ(jumps.largest_m, 0.5);
  EXPECT_EQ(jumps.at, (Vec2{100, 0}));
}

TEST(MeasureJumps, FindsBridgesThatEndInTheAir) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 0}, {100, 0}}, 0, 10)};
  chunk.bridges = {{sloping_road(2, {{100, 0}, {200, 0}}, 10.25, 10), {}, {}, {}, {}, {}}};
  EXPECT_EQ(measure_jumps(scene_of_chunk(chunk)).largest_m, 0.25);
}

TEST(MeasureCrossingSteps, FindsWaysThatCrossWithoutANodeAtDifferentHeights) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 50}, {100, 50}}, 0, 10), sloping_road(2, {{50, 0}, {50, 100}}, 8, 8)};
  const std::vector<CrossingStep> steps = measure_crossing_steps(scene_of_chunk(chunk));
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].step_m, 3);
  EXPECT_EQ(steps[0].at, (Vec2{50, 50}));
  EXPECT_EQ(steps[0].first.id, 1);
  // with a common node the junction has one height
  chunk.roads = {sloping_road(1, {{0, 50}, {50, 50}, {100, 50}}, 0, 10),
                 sloping_road(2, {{50, 0}, {50, 50}, {50, 100}}, 8, 8)};
  EXPECT_TRUE(measure_crossing_steps(scene_of_chunk(chunk)).empty());
}

TEST(MeasureJumps, IgnoresBridgesAboveVertices) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 0}, {100, 0}}, 0, 10)};
  chunk.bridges = {{sloping_road(2, {{100, -50}, {100, 0}, {100, 50}}, 20, 20), {}, {}, {}, {}, {}}};
  EXPECT_EQ(measure_jumps(scene_of_chunk(chunk)).largest_m, 0);
}

TEST(MeasureJumps, SkipsLinesWithoutAProfile) {
  scene::Chunk chunk;
  chunk.roads = {sloping_road(1, {{0, 0}, {100, 0}}, 300, 310), sloping_road(2, {{100, 0}, {200, 0}}, 310, 300)};
  chunk.bridges = {{sloping_road(3, {{0, 0}, {0, 100}}, 300, 300), {}, {}, {}, {}, {}}};
  chunk.roads[1].profile.clear(), chunk.bridges[0].profile.clear();
  const Jumps jumps = measure_jumps(scene_of_chunk(chunk));
  EXPECT_EQ(jumps.largest_m, 0);
  EXPECT_EQ(jumps.places, 0u);
}

roads::Strip stream(std::int64_t id, Polyline axis, double start_along_m, Profile profile) {
  return {{{OsmType::kWay, id}, 0}, std::move(axis), map::LandCoverClass::kRiver, 2, 2,
          std::move(profile),       start_along_m};
}

TEST(MeasureRises, FindsWhatFlowsUphill) {
  scene::Chunk chunk;
  chunk.heights = {{0, 0}, {64, 64}, 2, 2, {0, 0, 0, 0}};
  chunk.watercourses = {stream(1, {{0, 0}, {100, 0}}, 0, {{0, 5, 0}, {50, 3, 0}, {100, 4, 0}})};
  EXPECT_EQ(measure_rises(chunk).rising, 1u);
  chunk.watercourses[0].profile[2].z_m = 3;
  EXPECT_EQ(measure_rises(chunk).rising, 0u);
}

TEST(MeasureRises, CountsTrimmedStreamsFromTheirBeginning) {
  scene::Chunk chunk;
  chunk.heights = {{0, 0}, {64, 64}, 2, 2, {0, 0, 0, 0}};
  const Profile profile = {{0, 9, 0}, {100, 5, 0}, {200, 0, 0}};
  chunk.watercourses = {stream(1, {{0, 0}, {100, 0}}, 0, profile), stream(2, {{100, 0}, {200, 0}}, 100, profile)};
  EXPECT_EQ(measure_rises(chunk).rising, 0u);
  EXPECT_EQ(measure_rises(chunk).largest_m, 0);
}

}  // namespace
}  // namespace citykiln::verify
