#include "compiler/verify/standing/measure_wires.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

// A wire along y = 32 over a road from x = 20 to x = 28, on ground that is 10 m high.
WiresOverRoads wires_at(double from_m, double to_m, double sag_m) {
  const Ring road = {{20, 0}, {28, 0}, {28, 64}, {20, 64}};
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kGroundFeature, 0}, map::LandCoverClass::kResidentialRoad, 512, {road}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kMadeBox);
  scene::Chunk chunk;
  chunk.wire_spans.push_back({{{OsmType::kWay, 9}, 1}, 20, {{{-40, 32, from_m}, {88, 32, to_m}, sag_m, 15, {}}}});
  const GroundIndex ground = index_ground(made_ground(map::LandCoverClass::kResidentialRoad, {0, 0, 0, 0}));
  return measure_wires(chunk, kMadeBox, cover, ground, 4.5);
}

TEST(MeasureWires, FindsTheLowestPlaceOverARoad) {
  const WiresOverRoads found = wires_at(20, 20, 4);
  EXPECT_EQ(found.spans, 1u);
  EXPECT_EQ(found.low, 0u);
  EXPECT_NEAR(found.lowest_m, 6, 0.02);
  EXPECT_TRUE(found.at.x >= 20 && found.at.x <= 28);
  EXPECT_EQ(found.lowest.id, 9);
}

TEST(MeasureWires, CountsSpansThatAreLow) { EXPECT_EQ(wires_at(18, 18, 4).low, 1u); }

TEST(MeasureWires, LeavesOutPlacesBesideTheRoad) {
  // low at its end, far from the road
  EXPECT_EQ(wires_at(30, 10, 0).low, 0u);
}

}  // namespace
}  // namespace citykiln::verify
