#include "compiler/verify/heights/measure_road_faces.h"

#include <gtest/gtest.h>

#include "compiler/ground/grading/road_influence.h"
#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

roads::Road sloping_road_with_lane(std::int64_t id, Polyline axis, double from_m, double to_m) {
  roads::Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.section.lanes = {{}};
  road.profile = {{0, from_m, 0}, {length_m(axis), to_m, 0}};
  road.axis = std::move(axis);
  return road;
}

/// The largest gap where the ground rises eastwards from 10 m by an eighth, and lies so much too high.
RoadFaces faces_of(const std::vector<roads::Road>& roads, double too_high_m) {
  scene::Chunk chunk;
  chunk.roads = roads;
  return measure_road_faces(chunk, kMadeBox, true,
                            [&](const roads::Road&, Vec2 p) { return std::vector{10 + p.x / 8 + too_high_m}; });
}

TEST(MeasureRoadFaces, FindsNothingWhereTheGroundIsTheProfile) {
  const RoadFaces faces = faces_of({sloping_road_with_lane(1, {{0, 32}, {64, 32}}, 10, 18)}, 0);
  EXPECT_GE(faces.places, 16u);
  EXPECT_EQ(faces.largest_gap_m, 0);
}

TEST(MeasureRoadFaces, FindsGroundOverTheRoad) {
  EXPECT_EQ(faces_of({sloping_road_with_lane(1, {{0, 32}, {64, 32}}, 10, 18)}, 0.5).largest_gap_m, 0.5);
}

TEST(MeasureRoadFaces, TakesACarriagewayBetweenKerbs) {
  EXPECT_EQ(faces_of({sloping_road_with_lane(1, {{0, 32}, {64, 32}}, 10, 18)}, -ground::kKerbRise_m).largest_gap_m, 0);
}

TEST(MeasureRoadFaces, SkipsPlacesNearOtherRoads) {
  const roads::Road along = sloping_road_with_lane(1, {{0, 32}, {64, 32}}, 10, 18),
                    across = sloping_road_with_lane(2, {{32, 0}, {32, 64}}, 14, 14);
  const RoadFaces alone = faces_of({along}, 0), crossed = faces_of({along, across}, 0);
  EXPECT_GT(crossed.places, alone.places);
  EXPECT_LT(crossed.places, 2 * alone.places);
  EXPECT_EQ(crossed.largest_gap_m, 0);
}

}  // namespace
}  // namespace citykiln::verify
