#include "compiler/furniture/utility_poles.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

// A Japanese street of 6 m without kerbs along y = 0.
roads::Road lane_in_japan() {
  roads::Road road;
  road.id = {{OsmType::kWay, 7}, 0};
  road.axis = {{0, 0}, {1000, 0}};
  road.surface = LandCoverClass::kResidentialRoad;
  road.country = map::CountryGroup::kJapan;
  road.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 3},
                        {LaneKind::kDriving, LaneDirection::kForward, 3}};
  road.section.axis_offset_m = 3;  // from the carriageway's left edge
  return road;
}

constexpr Box2 kAllOfIt{{-64, -64}, {1100, 64}};

UtilityPoles poles_on(const roads::Road& road, const Box2& box, std::uint64_t seed) {
  const std::vector<ground::LandCoverPolygon> cover = {
      {road.id, road.surface, 0, {{{0, -3}, {1000, -3}, {1000, 3}, {0, 3}}}}};
  const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
  const std::vector<roads::Road> roads = {road};
  const roadside::TileRecipes recipes{.roads = roads,
                                      .junctions = {},
                                      .yards = {},
                                      .plots = {},
                                      .pitches = {},
                                      .trunks = {},
                                      .things = {},
                                      .lamps = {},
                                      .barriers = {},
                                      .buildings = {},
                                      .land_cover = index,
                                      .tile_m = 256};
  return utility_poles(recipes, roadside::clear_zones_of(recipes), seed, box);
}

TEST(UtilityPoles, StandInTheEdgeOfOneSideEvery32m) {
  std::set<double> sides;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const UtilityPoles made = poles_on(lane_in_japan(), kAllOfIt, seed);
    if (made.poles.empty()) continue;
    ASSERT_EQ(made.poles.size(), 32u);
    ASSERT_EQ(made.spans.size(), 31u);
    sides.insert(made.poles.front().at.y);
    for (const things::Thing& pole : made.poles) EXPECT_EQ(pole.at.y, made.poles.front().at.y);
    for (const PoleSpan& span : made.spans)
      EXPECT_NEAR(distance(made.poles[span.from].at, made.poles[span.to].at), kPoleStep_m, 0.01);
  }
  EXPECT_EQ(sides, (std::set<double>{-2.75, 2.75}));
}

TEST(UtilityPoles, AreWhereTheCountryHasThem) {
  int japan = 0, germany = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    roads::Road road = lane_in_japan();
    japan += poles_on(road, kAllOfIt, seed).poles.empty() ? 0 : 1;
    road.country = map::CountryGroup::kCentralEurope;
    germany += poles_on(road, kAllOfIt, seed).poles.empty() ? 0 : 1;
  }
  EXPECT_NEAR(japan, 180, 12);
  EXPECT_EQ(germany, 0);
}

TEST(UtilityPoles, SpansOfTilesAreThoseOfTheWhole) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    std::set<std::uint32_t> whole, parts;
    for (const PoleSpan& span : poles_on(lane_in_japan(), kAllOfIt, seed).spans) whole.insert(span.id.part);
    for (double x = -64; x < 1100; x += 194) {
      const UtilityPoles made = poles_on(lane_in_japan(), {{x, -64}, {x + 194, 64}}, seed);
      for (const PoleSpan& span : made.spans) EXPECT_TRUE(parts.insert(span.id.part).second);
    }
    EXPECT_EQ(parts, whole);
  }
}

TEST(UtilityPoles, AreNotBesideBroadPavements) {
  roads::Road road = lane_in_japan();
  road.section.lanes.insert(road.section.lanes.begin(), {LaneKind::kSidewalk, LaneDirection::kBoth, 4, 0, true});
  for (std::uint64_t seed = 0; seed < 20; ++seed) EXPECT_TRUE(poles_on(road, kAllOfIt, seed).poles.empty());
}

}  // namespace
}  // namespace citykiln::furniture
