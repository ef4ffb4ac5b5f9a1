#include "compiler/props/street_lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/roads/trim.h"

namespace citykiln::props {
namespace {

using map::LandCoverClass;
using roads::Road;

const Box2 kEverywhere{{-4096, -4096}, {4096, 4096}};

map::Lane lane(map::LaneKind kind, double width_m) {
  return {kind, map::LaneDirection::kBoth, width_m, 0, kind == map::LaneKind::kSidewalk};
}

// A lit road with pavements of a width (0: none), its axis in the middle of the carriageway.
Road road_on(Polyline axis, LandCoverClass surface, double width_m, double left_pavement_m = 0,
             double right_pavement_m = 0) {
  Road road;
  road.id = {{OsmType::kWay, 7}, 0};
  road.axis = std::move(axis);
  road.surface = surface;
  if (left_pavement_m > 0) road.section.lanes.push_back(lane(map::LaneKind::kSidewalk, left_pavement_m));
  road.section.lanes.push_back(lane(map::LaneKind::kDriving, width_m));
  if (right_pavement_m > 0) road.section.lanes.push_back(lane(map::LaneKind::kSidewalk, right_pavement_m));
  road.section.axis_offset_m = width_m / 2;
  road.is_lit = true;
  return road;
}

Road residential_street(Polyline axis) { return road_on(std::move(axis), LandCoverClass::kResidentialRoad, 6); }

// A winding road with segments of odd lengths.
Road winding() {
  Polyline axis;
  for (int i = 0; i < 160; ++i) axis.push_back(snapped(Vec2{i * 7.3, 40.0 * ((i * 37) % 11) / 11 + i * 2.1}));
  Road road = road_on(axis, LandCoverClass::kSecondaryRoad, 12);
  road.start_along_m = 101.25;
  return road;
}

ground::LandCoverPolygon square(LandCoverClass surface, Vec2 middle, double half_m) {
  const Box2 box = Box2{middle, middle}.widened(half_m);
  return {{{OsmType::kWay, 90}, 0}, surface, 0, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

std::vector<StreetLamp> on(std::vector<Road> roads, std::vector<ground::LandCoverPolygon> surfaces = {},
                           std::vector<Lamp> mapped = {}) {
  const Box2 box{{-512, -512}, {512, 512}};
  return lamps_of_streets(roads, mapped, ground::index_land_cover(surfaces, box), box);
}

TEST(LampsAlong, StandHalfASpacingFromTheStartThenOneASpacing) {
  for (const auto surface :
       {LandCoverClass::kMotorwayRoad, LandCoverClass::kPrimaryRoad, LandCoverClass::kSecondaryRoad,
        LandCoverClass::kTertiaryRoad, LandCoverClass::kResidentialRoad, LandCoverClass::kFootPath}) {
    const double spacing_m = lighting_of(surface).spacing_m;
    const auto lamps = lamps_along(road_on({{0, 0}, {90, 0}, {401, 0}}, surface, 8), kEverywhere);
    ASSERT_EQ(lamps.size(), static_cast<std::size_t>(401 / spacing_m + 0.5));
    for (std::size_t i = 0; i < lamps.size(); ++i) EXPECT_EQ(lamps[i].at.x, (static_cast<double>(i) + 0.5) * spacing_m);
  }
}

TEST(LampsAlong, AreCloserAndLowerOnQuieterStreets) {
  const LandCoverClass louder_first[] = {LandCoverClass::kMotorwayRoad,    LandCoverClass::kPrimaryRoad,
                                         LandCoverClass::kSecondaryRoad,   LandCoverClass::kTertiaryRoad,
                                         LandCoverClass::kResidentialRoad, LandCoverClass::kPavedFootPath};
  for (std::size_t i = 1; i < std::size(louder_first); ++i) {
    const Lighting loud = lighting_of(louder_first[i - 1]), quiet = lighting_of(louder_first[i]);
    EXPECT_GT(loud.spacing_m, quiet.spacing_m);
    EXPECT_GE(loud.height_m, quiet.height_m);
    EXPECT_GE(quiet.spacing_m / quiet.height_m, 3);
    EXPECT_LE(quiet.spacing_m / quiet.height_m, 5);
  }
}

TEST(LampsAlong, AreOnLitRoadsAloneNotOnRailsOrRunways) {
  Road dark = residential_street({{0, 0}, {400, 0}});
  dark.is_lit = false;
  EXPECT_TRUE(lamps_along(dark, kEverywhere).empty());
  for (const auto surface : {LandCoverClass::kTram, LandCoverClass::kRailway, LandCoverClass::kRunway})
    EXPECT_TRUE(lamps_along(road_on({{0, 0}, {400, 0}}, surface, 6), kEverywhere).empty());
}

TEST(LampsAlong, AlternateOnWideCarriageways) {
  const auto lamps = lamps_along(road_on({{0, 0}, {400, 0}}, LandCoverClass::kPrimaryRoad, 14), kEverywhere);
  ASSERT_GE(lamps.size(), 2u);
  for (std::size_t i = 0; i < lamps.size(); ++i) EXPECT_EQ(lamps[i].at.y, i % 2 == 0 ? -7.75 : 7.75);
}

TEST(LampsAlong, AreOnTheSideWithAPavementElseOnThatOfTraffic) {
  const Polyline axis = {{0, 0}, {400, 0}};
  const auto feet_m = [&](const Road& road) {
    const auto lamps = lamps_along(road, kEverywhere);
    for (const StreetLamp& lamp : lamps) EXPECT_EQ(lamp.at.y, lamps[0].at.y);
    return lamps[0].at.y;
  };
  const auto with = [&](double left_m, double right_m) {
    return road_on(axis, LandCoverClass::kResidentialRoad, 6, left_m, right_m);
  };
  EXPECT_EQ(feet_m(with(0, 0)), -3.75);
  EXPECT_EQ(feet_m(with(2, 0)), 3.5);
  EXPECT_EQ(feet_m(with(0, 2)), -3.5);
  EXPECT_EQ(feet_m(with(2, 2)), -3.5);
  EXPECT_EQ(feet_m(with(0, 0.5)), -3.25);
  Road cycled = with(0, 2);
  cycled.section.lanes.insert(cycled.section.lanes.begin() + 1,
                              {map::LaneKind::kCycle, map::LaneDirection::kForward, 1.5, 0, true});
  EXPECT_EQ(feet_m(cycled), -5);
  cycled.section.lanes.pop_back();
  EXPECT_EQ(feet_m(cycled), -5.25);
  Road left_hand = with(2, 2);
  left_hand.side = map::DrivingSide::kLeft;
  EXPECT_EQ(feet_m(left_hand), 3.5);
  Road shifted = with(0, 0);
  shifted.section.axis_offset_m = 5;
  EXPECT_EQ(feet_m(shifted), -1.75);
}

TEST(LampsAlong, FaceTheirAxisSquarely) {
  for (int i = 0; i < 24; ++i) {
    const Vec2 along{static_cast<double>(i % 5) - 2, static_cast<double>(i % 7) - 3.5};
    const auto lamps = lamps_along(residential_street({{3, 4}, snapped(Vec2{3, 4} + along * 60)}), kEverywhere);
    ASSERT_FALSE(lamps.empty());
    for (const StreetLamp& lamp : lamps) {
      const Vec2 from = lamp.at - Vec2{3, 4}, axis = unit(along);
      EXPECT_GT(dot(lamp.facing, unit(axis * dot(from, axis) - from)), 0.9999);
      EXPECT_NEAR(length(lamp.facing), 1, 1e-12);
    }
  }
}

TEST(LampsAlong, AreTheSameOfAWayAndOfItsTrimmedRuns) {
  const Road whole = winding();
  const auto lamps = lamps_along(whole, kEverywhere);
  ASSERT_GT(lamps.size(), 50u);
  std::vector<StreetLamp> joined;
  for (double x = -128; x < 1280; x += 128)
    for (double y = -128; y < 512; y += 128) {
      const Box2 tile{{x, y}, {x + 128, y + 128}};
      const auto here = lamps_along(whole, tile);
      std::vector<StreetLamp> of_runs;
      for (const Road& run : roads::trimmed_to(whole, tile, 16))
        for (const StreetLamp& lamp : lamps_along(run, tile)) of_runs.push_back(lamp);
      EXPECT_EQ(of_runs, here);
      joined.insert(joined.end(), here.begin(), here.end());
    }
  ASSERT_EQ(joined.size(), lamps.size());
  for (const StreetLamp& lamp : lamps) EXPECT_EQ(std::ranges::count(joined, lamp), 1);
}

TEST(LampsAlong, CostDependsOnTheBoxNotTheLengthOfTheWay) {
  Road endless = residential_street({{-0x1p40, -0x1p39}, {0x1p40, 0x1p39}});
  endless.start_along_m = 0x1p42;
  EXPECT_LE(lamps_along(endless, Box2{{0, 0}, {1024, 1024}}).size(), 50u);
  EXPECT_TRUE(lamps_along(residential_street({{0, 0}, {0, 0}}), kEverywhere).empty());
}

TEST(LampsOfStreets, KeepOffRoadsWaterAndBuildings) {
  const std::vector<Road> roads = {residential_street({{0, 0}, {200, 0}})};
  const Vec2 third = on(roads)[2].at;
  for (const auto surface :
       {LandCoverClass::kPrimaryRoad, LandCoverClass::kTram, LandCoverClass::kRailway, LandCoverClass::kRiver,
        LandCoverClass::kSea, LandCoverClass::kBuilding, LandCoverClass::kSteps, LandCoverClass::kCyclePath})
    EXPECT_EQ(on(roads, {square(surface, third, 3)}).size(), 7u);
  for (const auto surface : {LandCoverClass::kPavement, LandCoverClass::kGrass, LandCoverClass::kSquare,
                             LandCoverClass::kPavedFootPath, LandCoverClass::kTrafficIsland})
    EXPECT_EQ(on(roads, {square(surface, third, 3)}), on(roads));
}

TEST(LampsOfStreets, AreNoneNearMappedOnes) {
  const std::vector<Road> roads = {residential_street({{0, 0}, {300, 0}})};
  const auto alone = on(roads), beside = on(roads, {}, {{{{OsmType::kNode, 1}, 0}, {150, 5}, 0}});
  EXPECT_LT(beside.size(), alone.size());
  for (const StreetLamp& lamp : alone) {
    const bool is_near = distance(lamp.at, {150, 5}) < lighting_of(LandCoverClass::kResidentialRoad).spacing_m;
    EXPECT_EQ(std::ranges::count(beside, lamp), is_near ? 0 : 1);
  }
}

TEST(LampsOfStreets, AreNoneOnPathsBesideLitStreets) {
  const Road path = road_on({{0, 7}, {200, 7}}, LandCoverClass::kPavedFootPath, 2);
  Road near = residential_street({{0, 0}, {200, 0}});
  near.id.osm.id = 8;
  const std::size_t along_street = on({near}).size();
  EXPECT_EQ(on({path, near}).size(), along_street);
  Road dark = near;
  dark.is_lit = false;
  EXPECT_EQ(on({path, dark}).size(), 10u);
  Road far = near;
  for (Vec2& p : far.axis) p.y = -30;
  EXPECT_EQ(on({path, far}).size(), along_street + 10u);
}

TEST(MappedLamps, FaceTheNearestStreetThenTheNearestPath) {
  const Road path = road_on({{0, 6}, {200, 6}}, LandCoverClass::kFootPath, 2);
  Road primary = road_on({{0, 0}, {200, 0}}, LandCoverClass::kPrimaryRoad, 7);
  primary.is_lit = false;
  const std::vector<Road> roads = {path, primary};
  const std::vector<Lamp> lamps = {{{{OsmType::kNode, 1}, 0}, {50, 5}, 0},
                                   {{{OsmType::kNode, 2}, 0}, {50, 14}, 0},
                                   {{{OsmType::kNode, 3}, 0}, {50, 80}, 0},
                                   {{{OsmType::kNode, 4}, 0}, {50, -4}, 7.5}};
  const auto standing = mapped_lamps(lamps, roads);
  ASSERT_EQ(standing.size(), 4u);
  EXPECT_EQ(standing[0],
            (StreetLamp{{50, 5}, {0, -1}, 10, LampKind::kArm, lamps[0].id.osm, luminaire_of(LampKind::kArm, 10)}));
  EXPECT_EQ(
      standing[1],
      (StreetLamp{{50, 14}, {0, -1}, 4, LampKind::kPostTop, lamps[1].id.osm, luminaire_of(LampKind::kPostTop, 4)}));
  EXPECT_EQ(
      standing[2],
      (StreetLamp{{50, 80}, {1, 0}, 6, LampKind::kPostTop, lamps[2].id.osm, luminaire_of(LampKind::kPostTop, 6)}));
  EXPECT_EQ(standing[3],
            (StreetLamp{{50, -4}, {0, 1}, 7.5, LampKind::kArm, lamps[3].id.osm, luminaire_of(LampKind::kArm, 7.5)}));
}

TEST(MappedLamps, HaveTheLightAndTheMountOfTheirTags) {
  const Road path = road_on({{0, 6}, {200, 6}}, LandCoverClass::kFootPath, 2);
  const Lamp gas{{{OsmType::kNode, 1}, 0}, {50, 9}, 0, {.type = map::LampType::kGas}};
  const Lamp bent{{{OsmType::kNode, 2}, 0}, {50, 9}, 0, {.mount = map::LampMount::kBentMast, .lumen = 5000}};
  const auto standing = mapped_lamps(std::array{gas, bent}, std::array{path});
  EXPECT_EQ(standing[0].kind, LampKind::kPostTop);
  EXPECT_EQ(standing[0].light, (Luminaire{1000, 2700, Beam::kLantern}));
  EXPECT_EQ(standing[1].kind, LampKind::kArm);
  EXPECT_EQ(standing[1].light.lumen, 5000);
  EXPECT_EQ(standing[1].light.beam, Beam::kDown);
}

TEST(MappedLamps, BetweenTwoEquallyNearStreetsFaceTheFirst) {
  Road first = residential_street({{0, 0}, {200, 0}}), second = residential_street({{0, 10}, {200, 10}});
  second.id.osm.id = 8;
  const std::vector<Lamp> lamps = {{{{OsmType::kNode, 1}, 0}, {50, 5}, 0}};
  EXPECT_EQ(mapped_lamps(lamps, std::vector<Road>{first, second})[0].facing, (Vec2{0, -1}));
  EXPECT_EQ(mapped_lamps(lamps, std::vector<Road>{second, first})[0].facing, (Vec2{0, 1}));
  // on the axis itself
  EXPECT_EQ(mapped_lamps(std::vector<Lamp>{{{}, {50, 0}, 0}}, std::vector<Road>{first})[0].facing, (Vec2{1, 0}));
}

}  // namespace
}  // namespace citykiln::props
