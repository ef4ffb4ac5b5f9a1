#include "compiler/lots/mapped_things.h"

#include <gtest/gtest.h>

#include "tests/compiler/lots/made_town.h"

namespace citykiln::lots {
namespace {

// The distance from the node at (0, 0) to the circle about it, less half of the streets' width.
double clear_of_junction_m(map::LandCoverClass surface) {
  map::Features town;
  town.tracks = {street(1, {{-60, 0}, {0, 0}, {60, 0}}, surface), street(2, {{0, 0}, {0, 60}}, surface)};
  town.tracks[1].node_ids[0] = town.tracks[0].node_ids[1];
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(town, report);
  const MappedThings mapped = mapped_things(town, roads, roads::plan_junctions(roads, report), {});
  EXPECT_FALSE(mapped.junction_zones.all.empty());
  double half_m = 0;
  for (const roads::Road& road : roads) half_m = std::max(half_m, roads::width_m(road) / 2);
  return -clearance_m(mapped.junction_zones, {0, 0}, 100) - half_m;
}

TEST(MappedThings, CrossingsOfStreetsNeedSightAndOthersTheirOutline) {
  EXPECT_DOUBLE_EQ(clear_of_junction_m(map::LandCoverClass::kResidentialRoad), kSight_m);
  EXPECT_DOUBLE_EQ(clear_of_junction_m(map::LandCoverClass::kServiceRoad), kBesideJunction_m);
}

// Two ways that meet at 15 degrees: the corner of their junction is far from its node.
TEST(MappedThings, CornersOfJunctionsReachFarAtSmallAngles) {
  map::Features town;
  const auto service = map::LandCoverClass::kServiceRoad;
  town.tracks = {street(1, {{-60, 0}, {0, 0}, {60, 0}}, service), street(2, {{0, 0}, {60, 16}}, service)};
  town.tracks[1].node_ids[0] = town.tracks[0].node_ids[1];
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(town, report);
  const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, report);
  const MappedThings mapped = mapped_things(town, roads, junctions, {});
  ASSERT_EQ(junctions.size(), 1u);
  double farthest_m = 0;
  const auto outlines = roads::outline_junctions(junctions, roads, 1);
  for (const Polygon& outline : outlines[0])
    for (const Vec2 p : outline.outer) {
      EXPECT_LT(clearance_m(mapped.junction_zones, p, 10), -0.9 * kBesideCorner_m) << p.x << " " << p.y;
      farthest_m = std::max(farthest_m, length(p));
    }
  EXPECT_GT(farthest_m, 8);
}

TEST(MappedThings, OuterCornersOfBendsAreSurfacesOfRoads) {
  map::Features town;
  town.tracks = {street(1, {{-60, 0}, {0, 0}, {0, 60}}), street(2, {{200, 0}, {140, 0}, {140, -60}})};
  Report report;
  const std::vector<roads::Road> roads = roads::roads_on_ground(town, report);
  const MappedThings mapped = mapped_things(town, roads, {}, {});
  ASSERT_EQ(roads.size(), 2u);
  for (const roads::Road& road : roads) {
    const bool is_left_turn = cross(road.axis[1] - road.axis[0], road.axis[2] - road.axis[1]) > 0;
    const double aside_m = is_left_turn ? roads::right_m(road) + roads::raised_right_m(road)
                                        : roads::left_m(road) + roads::raised_left_m(road);
    const Vec2 in = unit(road.axis[1] - road.axis[0]), out = unit(road.axis[2] - road.axis[1]);
    const Vec2 tip = (in - out) * aside_m;
    EXPECT_TRUE(is_inside_any(mapped.corners, road.axis[1] + tip * 0.98)) << road.id.osm.id;
    EXPECT_GT(clearance_m(mapped.roads, road.axis[1] + tip * 0.98, 10), 0) << "beyond the strips";
    EXPECT_FALSE(is_inside_any(mapped.corners, road.axis[1] + tip * 1.02));
  }
}

TEST(MappedThings, RoadsWhoseAxisDriftsAreAsWideAsTheyAreAtEachPlace) {
  map::Features town;
  town.tracks = {street(1, {{0, 0}, {50, 0}, {100, 0}})};
  Report report;
  std::vector<roads::Road> roads = roads::roads_on_ground(town, report);
  ASSERT_EQ(roads.size(), 1u);
  roads[0].section.axis_drift = 0.0625;
  const double left_m = roads::left_m(roads[0]) + roads::raised_left_m(roads[0]);
  const MappedThings mapped = mapped_things(town, roads, {}, {});
  EXPECT_LT(clearance_m(mapped.roads, {99, left_m + 5.75}, 10), 0.05) << "6.25 m farther left at the end";
}

}  // namespace
}  // namespace citykiln::lots
