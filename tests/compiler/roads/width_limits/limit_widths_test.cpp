#include "compiler/roads/width_limits/limit_widths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/geometry/snap.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/trim.h"
#include "compiler/roads/width_limits/building_obstacles.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/made_footprint.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

using Roads = std::vector<Road>;
using Footprints = std::vector<map::Footprint>;

Roads narrowed(const Roads& roads, const Footprints& footprints) {
  Report report;
  return limit_widths(roads, plan_junctions(roads, report), footprints, {}, report);
}

Road street_with_pavements(std::int64_t id, Polyline axis) {
  return made_road(id, std::move(axis), 7, map::LandCoverClass::kResidentialRoad, 2, 2);
}

// A road with random bends, some sharp.
Road winding_street(std::mt19937_64& dice) {
  const auto unit = [&] { return static_cast<double>(dice() % 1000) / 1000; };
  Polyline axis = {{0, 0}};
  double heading = 0;
  for (int i = 0; i < 8; ++i) {
    heading += (unit() - 0.5) * (dice() % 6 == 0 ? 4.5 : 1.2);
    axis.push_back(snapped(axis.back() + Vec2{std::cos(heading), std::sin(heading)} * (5 + 40 * unit())));
  }
  Road road = street_with_pavements(1, axis);
  road.section.axis_offset_m = snapped(7 * unit());
  return road;
}

double distance_m(const Ring& ring, const Polyline& axis) {
  const Shape a = shape({ring, {}});
  GEOSCoordSequence* points = GEOSCoordSeq_create(static_cast<unsigned>(axis.size()), 2);
  for (unsigned i = 0; i < axis.size(); ++i) GEOSCoordSeq_setXY(points, i, axis[i].x, axis[i].y);
  const Shape b(GEOSGeom_createLineString(points));
  double d = 0;
  GEOSDistance(a.get(), b.get(), &d);
  return d;
}

// Houses of random size and direction along a road, at a minimum distance from its axis.
Footprints houses_about(const Road& road, double least_m, std::mt19937_64& dice) {
  const auto unit = [&] { return static_cast<double>(dice() % 1000) / 1000; };
  const Box2 box = box_of(road.axis).widened(12);
  Footprints houses;
  for (int i = 0; i < 300; ++i) {
    const Vec2 at = box.min + Vec2{box.width() * unit(), box.height() * unit()};
    const double turn = 7 * unit();
    const Vec2 u = Vec2{std::cos(turn), std::sin(turn)} * (1 + 12 * unit()), v = left_of(u) * (0.2 + unit());
    Ring ring = {snapped(at), snapped(at + u), snapped(at + u + v), snapped(at + v)};
    if (distance_m(ring, road.axis) >= least_m) houses.push_back(made_footprint(i + 1, std::move(ring)));
  }
  return houses;
}

double largest_shared_m2(std::span<const Ring> rings, const map::Footprint& footprint) {
  const Box2 box = box_of(footprint.polygon.outer);
  double most = 0;
  for (const Ring& ring : rings)
    if (box_of(ring).touches(box))
      most = std::max(most, area_of(Shape(GEOSIntersection(shape({ring, {}}).get(), shape(footprint.polygon).get()))));
  return most;
}

TEST(LimitWidths, KeepsEdgesOutOfFootprintsWhereTheLeastWidthAllows) {
  const Geos geos;
  std::mt19937_64 dice(3);
  double before = 0;
  for (int run = 0; run < 60; ++run) {
    const Road road = winding_street(dice);
    // the axis may be off the middle; the minimum half width is measured from the middle
    const double least_m = std::abs(left_m(road) - right_m(road)) / 2 + 1.3;
    const Footprints houses = houses_about(road, least_m, dice);
    const Roads after = narrowed({road}, houses);
    const std::vector<Ring> whole = stroke_pavements(road), rings = stroke_pavements(after[0]);
    for (const map::Footprint& house : houses) {
      before += largest_shared_m2(whole, house);
      ASSERT_LT(largest_shared_m2(rings, house), 0.02) << run << " " << house.id.osm.id;
    }
  }
  EXPECT_GT(before, 1000);
}

TEST(LimitWidths, TurnsEdgesByNoMoreThanOneInEight) {
  const Geos geos;
  std::mt19937_64 dice(4);
  int limited = 0;
  for (int run = 0; run < 40; ++run) {
    const Road plain = winding_street(dice);
    const Road road = narrowed({plain}, houses_about(plain, 0.5, dice))[0];
    limited += road.width_limits.is_empty() ? 0 : 1;
    constexpr double kApart_m = 0.0625;
    RoadEdges last = road_edges_at(road, 0);
    for (double along = kApart_m; along < distances_along(road).back(); along += kApart_m) {
      const RoadEdges e = road_edges_at(road, along);
      for (const auto edge :
           {&RoadEdges::left_m, &RoadEdges::kerb_left_m, &RoadEdges::kerb_right_m, &RoadEdges::right_m})
        ASSERT_LE(std::abs(e.*edge - last.*edge), kTaper * kApart_m + 1e-9) << run << " " << along;
      ASSERT_GE(e.kerb_left_m + e.kerb_right_m, kMinCarriageway_m - 1e-9);
      last = e;
    }
  }
  EXPECT_GT(limited, 20);
}

TEST(LimitWidths, LeavesAStreetWithNoBuildingNearAsItIs) {
  const Roads roads = {street_with_pavements(1, {{0, 0}, {100, 0}}), street_with_pavements(2, {{100, 0}, {200, 30}})};
  EXPECT_EQ(narrowed(roads, {made_box(1, {20, 5.5}, {40, 20})}), roads);
  EXPECT_NE(narrowed(roads, {made_box(1, {20, 5.25}, {40, 20})}), roads);
}

TEST(LimitWidths, MirrorsWithItsInput) {
  const Geos geos;
  std::mt19937_64 dice(5);
  const auto mirror = [](Vec2& p) { p.x = -p.x; };
  int limited = 0;
  for (int run = 0; run < 30; ++run) {
    Road road = winding_street(dice);
    Footprints houses = houses_about(road, 0.5, dice);
    const Road here = narrowed({road}, houses)[0];
    std::ranges::for_each(road.axis, mirror);
    road.section.axis_offset_m = 7 - road.section.axis_offset_m;
    for (map::Footprint& house : houses) {
      std::ranges::for_each(house.polygon.outer, mirror);
      std::ranges::reverse(house.polygon.outer);
    }
    const Road there = narrowed({road}, houses)[0];
    limited += here.width_limits.is_empty() ? 0 : 1;
    ASSERT_EQ(here.width_limits.left, there.width_limits.right) << run;
    ASSERT_EQ(here.width_limits.right, there.width_limits.left) << run;
  }
  EXPECT_GT(limited, 10);
}

TEST(LimitWidths, DoesNotDependOnTheOrderOfItsInput) {
  const Geos geos;
  std::mt19937_64 dice(6);
  const Road road = winding_street(dice);
  const Vec2 end = road.axis.back();
  Roads roads = {road, street_with_pavements(2, {end, snapped(end + Vec2{60, 5})}),
                 street_with_pavements(3, {{-50, 5}, {0, 0}})};
  Footprints houses = houses_about(road, 0.5, dice);
  const Roads sorted = narrowed(roads, houses);
  std::ranges::reverse(roads), std::ranges::shuffle(houses, dice);
  Roads turned = narrowed(roads, houses);
  std::ranges::reverse(turned);
  EXPECT_EQ(sorted, turned);
}

TEST(LimitWidths, GoesOnWhereRoadsJoin) {
  // a house that ends 3/4 m before the joint limits both roads
  const Footprints houses = {made_box(1, {90, 3}, {99.1, 20})};
  for (const bool is_turned : {false, true}) {
    Polyline second = {{100, 0}, {200, 0}};
    if (is_turned) std::ranges::reverse(second);
    const Roads roads =
        narrowed({street_with_pavements(1, {{0, 0}, {100, 0}}), street_with_pavements(2, second)}, houses);
    const RoadEdges before = road_edges_at(roads[0], 100), after = road_edges_at(roads[1], is_turned ? 100 : 0);
    EXPECT_DOUBLE_EQ(before.left_m, 3.09375);
    EXPECT_DOUBLE_EQ(is_turned ? after.right_m : after.left_m, 3.09375);
    EXPECT_DOUBLE_EQ(is_turned ? after.left_m : after.right_m, 5.5);
  }
}

TEST(LimitWidths, LeavesCarriagewaysWholeAtJunctions) {
  Report report;
  const Roads roads = {street_with_pavements(1, {{0, 0}, {100, 0}, {200, 0}}),
                       street_with_pavements(2, {{100, 0}, {100, -90}})};
  const std::vector<Junction> junctions = plan_junctions(roads, report);
  const Roads after = limit_widths(roads, junctions, std::vector{made_box(1, {80, 2}, {120, 20})}, {}, report);
  double cut = 0;
  for (const Cut& c : junctions[0].cuts) cut = std::max(cut, c.length_m);
  for (const double along : {100 - cut, 100.0, 100 + cut})
    EXPECT_DOUBLE_EQ(road_edges_at(after[0], along).kerb_left_m, 3.5);
  EXPECT_LT(road_edges_at(after[0], 80).kerb_left_m, 3.5);
  EXPECT_LT(road_edges_at(after[0], 100).left_m, 5.5);
}

TEST(LimitWidths, IsNotAskedByWhatTheAxisRunsThrough) {
  Report report;
  const Roads roads = {street_with_pavements(1, {{0, 0}, {100, 0}})};
  const Roads after = limit_widths(roads, {}, std::vector{made_box(1, {40, -8}, {50, 9})}, {}, report);
  EXPECT_EQ(after, roads);
  ASSERT_EQ(report.counts().count(Code::kBuildingOnRoad), 1u);
  EXPECT_NEAR(report.diagnoses().front().size, 10, 0.5);
}

TEST(LimitWidths, SaysNothingOfWaysThatLeadThroughBuildingsByTheirTags) {
  Report report;
  const std::vector<OsmId> passages = {{OsmType::kWay, 1}};
  limit_widths({street_with_pavements(1, {{0, 0}, {100, 0}})}, {}, std::vector{made_box(1, {40, -8}, {50, 9})},
               passages, report);
  EXPECT_TRUE(report.diagnoses().empty());
  limit_widths({street_with_pavements(2, {{0, 0}, {100, 0}})}, {}, std::vector{made_box(1, {40, -8}, {50, 9})},
               passages, report);
  EXPECT_EQ(report.diagnoses().size(), 1u);
}

TEST(LimitWidths, IsNotAskedByRoofsAndWhatHangsAbove) {
  const Roads roads = {street_with_pavements(1, {{0, 0}, {100, 0}})};
  Footprints houses(3, made_box(1, {40, 2}, {50, 9}));
  houses[0].min_height_m = 3, houses[1].has_parts = true;
  houses[2].is_open = true;
  EXPECT_EQ(narrowed(roads, houses), roads);
}

TEST(LimitWidths, SaysWhatIsLeftInTheWay) {
  Report report;
  const Roads after = limit_widths({street_with_pavements(1, {{0, 0}, {100, 0}})}, {},
                                   std::vector{made_box(1, {40, 0.5}, {50, 9})}, {}, report);
  EXPECT_DOUBLE_EQ(road_edges_at(after[0], 45).left_m, kMinCarriageway_m / 2);
  ASSERT_EQ(report.diagnoses().size(), 2u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kRoadNarrowed);
  EXPECT_DOUBLE_EQ(report.diagnoses()[0].size, 4.25);
  EXPECT_EQ(report.diagnoses()[1].code, Code::kBuildingOnRoad);
  EXPECT_NEAR(report.diagnoses()[1].size, 10, 0.5);
}

TEST(LimitWidths, DependsOnNothingFarOff) {
  const Roads roads = {street_with_pavements(1, {{0, 0}, {600, 0}})};
  Footprints houses;
  for (int i = 0; i < 60; ++i) houses.push_back(made_box(i, {i * 10.0, 3 + i % 7 * 0.3}, {i * 10.0 + 9, 20}));
  const Road all = narrowed(roads, houses)[0];
  houses.erase(houses.begin(), houses.begin() + 20);
  const Road some = narrowed(roads, houses)[0];
  // farther than a taper and a block from the last removed house
  for (double along = 200 + 8 * 5.5 + 64; along < 600; along += 0.25)
    ASSERT_EQ(road_edges_at(all, along).left_m, road_edges_at(some, along).left_m) << along;
}

TEST(LimitWidths, IsTheSameInTrimmedRuns) {
  const Geos geos;
  std::mt19937_64 dice(9);
  for (int run = 0; run < 20; ++run) {
    const Road plain = winding_street(dice);
    const Road road = narrowed({plain}, houses_about(plain, 0.5, dice))[0];
    const std::vector<Ring> whole = stroke_pavements(road);
    const Vec2 at = road.axis[dice() % road.axis.size()];
    const std::vector<Road> parts = trimmed_to(road, Box2{at, at}.widened(6), 3);
    ASSERT_FALSE(parts.empty());
    for (const Road& part : parts) {
      const std::vector<double> along = distances_along(part);
      for (double s = along.front(); s <= along.back(); s += 0.1) {
        ASSERT_EQ(road_edges_at(part, s).left_m, road_edges_at(road, s).left_m);
        ASSERT_EQ(road_edges_at(part, s).kerb_right_m, road_edges_at(road, s).kerb_right_m);
      }
      for (const Ring& ring : stroke_pavements(part)) ASSERT_NE(std::ranges::find(whole, ring), whole.end());
    }
  }
}

TEST(LimitWidths, TakesAnythingForARoad) {
  Report report;
  const Roads odd = {street_with_pavements(1, {{0, 0}, {0x1p-10, 0}}),
                     street_with_pavements(2, {{0, 0}, {9, 0}, {0, 0}}),
                     street_with_pavements(3, {{0, 0}, {30, 0}, {30, 30}, {0, 0}})};
  const Footprints houses = {made_box(1, {0, 0}, {9, 9}), made_box(2, {-3, 1}, {40, 2}),
                             made_footprint(3, {{0, 0}, {9, 0}, {4, 0x1p-10}})};
  EXPECT_EQ(limit_widths(odd, plan_junctions(odd, report), houses, {}, report).size(), 3u);
  EXPECT_TRUE(limit_widths({}, {}, houses, {}, report).empty());
}

}  // namespace
}  // namespace citykiln::roads
