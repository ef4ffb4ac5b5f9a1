#include "compiler/things/railings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"

namespace citykiln::things {
namespace {

using map::LandCoverClass;

constexpr OsmId kSquareId{OsmType::kWay, 7}, kOtherId{OsmType::kWay, 8};

// Land at 10 m, which falls by drop_m between y = 30 and y = 31.
ground::GradedTerrain terrace(double drop_m) {
  map::Heightfield field{{0, 0}, {1, 1}, 257, 129, {}, 0};
  for (int y = 0; y < 129; ++y)
    for (int x = 0; x < 257; ++x)
      field.heights.push_back(static_cast<std::int32_t>((10 - (y > 30 ? drop_m : 0)) / map::kHeightQuantum_m));
  return ground::GradedTerrain(std::move(field));
}

ground::LandCoverPolygon cover_of(OsmId id, LandCoverClass surface, Vec2 low, Vec2 high) {
  return {.id = {id, 0}, .surface = surface, .area_m2 = 500, .rings = {{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

// A square from x = 10 to 60 whose northern side is the edge of the terrace.
struct Terrace {
  map::Features features;
  std::vector<ground::LandCoverPolygon> cover{cover_of(kSquareId, LandCoverClass::kSquare, {10, 10}, {60, 30})};
  std::vector<roads::Road> roads;
  std::vector<structures::Span> bridges;
  std::vector<buildings::Building> buildings;
  double drop_m = 3;

  Terrace() { features.extent = {{0, 0}, {256, 128}}; }
  std::vector<props::Barrier> railings(Report& report) const {
    const ground::GradedTerrain ground = terrace(drop_m);
    return assumed_railings(
        features, {.cover = cover, .roads = roads, .bridges = bridges, .buildings = buildings, .ground = ground},
        report);
  }
  std::vector<props::Barrier> railings() const {
    Report report;
    return railings(report);
  }
};

double metres_of(const std::vector<props::Barrier>& railings) {
  double sum_m = 0;
  for (const props::Barrier& railing : railings) sum_m += length_m(railing.axis);
  return sum_m;
}

// True if a railing stands on the edge at this x.
bool stands_at(const std::vector<props::Barrier>& railings, double x) {
  return std::ranges::any_of(railings, [&](const auto& railing) {
    return distance_to_polyline(railing.axis, {x, 30 - kInsideEdge_m}) < 0.5;
  });
}

TEST(Railings, StandInsideTheEdgeOfADrop) {
  Report report;
  const auto railings = Terrace().railings(report);
  EXPECT_NEAR(metres_of(railings), 50, 3);
  for (const props::Barrier& railing : railings) {
    EXPECT_EQ(railing.kind, map::BarrierKind::kRailing);
    EXPECT_EQ(railing.id.osm, kSquareId);
    for (const Vec2 p : railing.axis) EXPECT_NEAR(p.y, 30 - kInsideEdge_m, 0.01);
  }
  EXPECT_EQ(report.assumed(Assumption::kRailings), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Railings, AreNotAtDropsOfAMetre) {
  Terrace low;
  low.drop_m = 1;
  EXPECT_TRUE(low.railings().empty());
}

TEST(Railings, StandOnlyWherePeopleWalk) {
  for (const LandCoverClass surface : {LandCoverClass::kPier, LandCoverClass::kFootPath, LandCoverClass::kPark,
                                       LandCoverClass::kResidentialRoad, LandCoverClass::kSteps}) {
    Terrace terrace;
    terrace.cover[0].surface = surface;
    EXPECT_TRUE(terrace.railings().empty());
  }
}

TEST(Railings, EndAtMappedBarriersDoorsAndDecks) {
  Terrace terrace;
  terrace.features.barriers = {{{kOtherId, 0}, {{20, 30}, {30, 30}}, map::BarrierKind::kWall, 1, 0.3}};
  EXPECT_FALSE(stands_at(terrace.railings(), 25));
  EXPECT_TRUE(stands_at(terrace.railings(), 40));

  Terrace with_door;
  buildings::Building house;
  house.footprint.outer = {{38, 34}, {38, 31}, {42, 31}, {42, 34}};
  house.facade_edges.assign(4, {});
  house.facade_edges[1].doors = 1 << 8;
  with_door.buildings = {house};
  EXPECT_FALSE(stands_at(with_door.railings(), 40.1));
  EXPECT_TRUE(stands_at(with_door.railings(), 20));

  Terrace with_bridge;
  structures::Span bridge;
  bridge.axis = {{40, 30}, {40, 60}};
  bridge.section.lanes = {{.width_m = 4}};
  bridge.section.axis_offset_m = 2;
  with_bridge.bridges = {bridge};
  EXPECT_FALSE(stands_at(with_bridge.railings(), 40));
  EXPECT_TRUE(stands_at(with_bridge.railings(), 50));
}

TEST(Railings, StandOnRetainingWallsThatAreNoParapet) {
  Terrace terrace;
  terrace.features.barriers = {{{kOtherId, 0}, {{10, 30.5}, {60, 30.5}}, map::BarrierKind::kRetainingWall, 3, 0.4}};
  EXPECT_GT(metres_of(terrace.railings()), 40) << "its top is level with the square";
  terrace.features.barriers[0].height_m = 4;
  EXPECT_TRUE(terrace.railings().empty()) << "it stands a metre above the square";
}

TEST(Railings, LeaveOpenWhereAWayLeadsAcross) {
  Terrace terrace;
  roads::Road path;
  path.id = {kOtherId, 0}, path.surface = LandCoverClass::kSteps;
  path.axis = {{40, 20}, {40, 50}};
  path.section.lanes = {{.width_m = 2}};
  path.section.axis_offset_m = 1;
  terrace.roads = {path};
  EXPECT_FALSE(stands_at(terrace.railings(), 40));
  EXPECT_TRUE(stands_at(terrace.railings(), 30));
  // a way that leads across so flatly that it is almost along the edge
  terrace.roads[0].axis = {{20, 27}, {60, 31}};
  for (const props::Barrier& railing : terrace.railings())
    for (std::size_t i = 1; i < railing.axis.size(); ++i)
      EXPECT_FALSE(crossing_shares(railing.axis[i - 1], railing.axis[i], Vec2{20, 27}, Vec2{60, 31}));
  terrace.roads[0].axis = {{10, 30}, {60, 30}};
  EXPECT_TRUE(stands_at(terrace.railings(), 40)) << "a way along the edge";
}

TEST(Railings, AreNotAtWallsAndPlatformsBesideTracks) {
  Terrace terrace;
  terrace.cover.push_back(cover_of(kOtherId, LandCoverClass::kBuilding, {20, 30}, {40, 50}));
  EXPECT_FALSE(stands_at(terrace.railings(), 30));
  EXPECT_TRUE(stands_at(terrace.railings(), 50));
  terrace.cover = {cover_of(kSquareId, LandCoverClass::kPlatform, {10, 10}, {60, 30}),
                   cover_of(kOtherId, LandCoverClass::kRailway, {0, 30}, {100, 34})};
  EXPECT_TRUE(terrace.railings().empty());
}

// Elements beyond the radius change nothing, nor does the order of the elements.
TEST(Railings, DependOnNothingBeyondTheRadius) {
  const auto near_origin = [](const std::vector<props::Barrier>& railings) {
    std::vector<Polyline> axes;
    for (const props::Barrier& railing : railings)
      if (railing.axis.front().x < 65) axes.push_back(railing.axis);
    std::ranges::sort(axes);
    return axes;
  };
  Terrace wide;
  wide.cover = {cover_of(kSquareId, LandCoverClass::kSquare, {10, 10}, {250, 30}),
                cover_of(kOtherId, LandCoverClass::kPark, {0, 0}, {128, 9})};
  const auto base = near_origin(wide.railings());
  EXPECT_FALSE(base.empty());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomSequence random(seed, stable_id(ObjectId{}), "railings");
    Terrace changed = wide;
    const double x = 65 + kRailingRadius_m + random.unit(1) * 40;
    changed.features.barriers = {{{kOtherId, 0}, {{x, 30}, {x + 5, 30}}, map::BarrierKind::kWall, 1, 0.3}};
    if (seed % 2 == 1) std::ranges::reverse(changed.cover);
    for (ground::LandCoverPolygon& polygon : changed.cover)
      std::ranges::rotate(polygon.rings[0], polygon.rings[0].begin() + static_cast<std::ptrdiff_t>(seed % 4));
    EXPECT_EQ(near_origin(changed.railings()), base);
  }
}

}  // namespace
}  // namespace citykiln::things
