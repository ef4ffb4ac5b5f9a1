#include "compiler/lots/add_yards.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/lots/mapped_things.h"
#include "tests/compiler/lots/made_town.h"

namespace citykiln::lots {
namespace {

using map::BarrierKind;
using map::CountryGroup;
using map::LandCoverClass;

constexpr CountryGroup kGroups[] = {CountryGroup::kCentralEurope, CountryGroup::kBritishIsles,
                                    CountryGroup::kNorthAmerica, CountryGroup::kJapan, CountryGroup::kSouthernEurope};
constexpr LandCoverClass kGrounds[] = {LandCoverClass::kLawn, LandCoverClass::kGravelYard, LandCoverClass::kPavedYard,
                                       LandCoverClass::kEarthYard};

bool is_in_yard(const map::Features& features, Vec2 p) {
  return std::ranges::any_of(kGrounds, [&](LandCoverClass c) { return is_in_any(yard_areas(features, c), p); });
}

TEST(AddYards, GroundBetweenPavementAndHouseIsClosed) {
  for (const CountryGroup group : kGroups) {
    const map::Features town = town_with_yards(made_town(group));
    for (double x = -100; x <= 90; x += 1.3)
      for (double y = 4.9; y < 24; y += 0.7) EXPECT_TRUE(is_in_yard(town, {x, y})) << x << ' ' << y;
  }
}

TEST(AddYards, PathsLeadFromTheDoorToThePavement) {
  for (const CountryGroup group : kGroups) {
    const map::Features town = town_with_yards(made_town(group));
    const std::vector<Polygon> paths = yard_areas(town, LandCoverClass::kYardPath);
    EXPECT_EQ(paths.size(), 8u);
    int entrances = 0;
    for (const map::PointFeature& point : town.points) {
      if (point.kind != map::PointKind::kEntrance) continue;
      ++entrances;
      for (double y = 4.9; y < 13; y += 0.5) EXPECT_TRUE(is_in_any(paths, {point.at.x, y}));
    }
    EXPECT_EQ(entrances, 8);
  }
}

TEST(AddYards, BarriersLeavePathsDrivesHousesAndPavementsFree) {
  int barriers = 0;
  for (const CountryGroup group : kGroups) {
    const map::Features town = town_with_yards(made_town(group));
    for (const map::Barrier& barrier : town.barriers) {
      ++barriers;
      for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i)
        for (double share = 0; share <= 1; share += 0.05) {
          const Vec2 p = barrier.axis[i] + (barrier.axis[i + 1] - barrier.axis[i]) * share;
          for (const LandCoverClass c : {LandCoverClass::kYardPath, LandCoverClass::kDrive})
            EXPECT_FALSE(is_in_any(yard_areas(town, c), p)) << p.x << ' ' << p.y;
          for (const map::Footprint& f : town.footprints) EXPECT_FALSE(contains(f.polygon, p));
          const Vec2 along = unit(barrier.axis[i + 1] - barrier.axis[i]);
          EXPECT_GE(p.y - std::abs(along.x) * barrier.width_m / 2, 4.99);
        }
    }
  }
  EXPECT_GT(barriers, 30);
}

TEST(AddYards, PlantsKeepOffBarriers) {
  int plants = 0;
  for (const CountryGroup group : kGroups) {
    const map::Features town = town_with_yards(made_town(group));
    for (const map::PointFeature& point : town.points) {
      if (point.kind != map::PointKind::kTree) continue;
      ++plants;
      for (const map::Barrier& barrier : town.barriers)
        EXPECT_GE(distance_to_polyline(barrier.axis, point.at), 0.74) << point.at.x << ' ' << point.at.y;
    }
  }
  EXPECT_GT(plants, 50);
}

TEST(AddYards, NeighboursHaveOneBorderBetweenThem) {
  const map::Features town = town_with_yards(made_town(CountryGroup::kNorthAmerica));
  // between the houses 3 and 4, behind their fronts
  int crossing = 0;
  for (const map::Barrier& barrier : town.barriers)
    for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i)
      crossing += crossing_shares(barrier.axis[i], barrier.axis[i + 1], {-10, 30}, {-2, 30}).has_value();
  EXPECT_EQ(crossing, 1);
}

TEST(AddYards, FrontLawnsOfNorthAmericaAreOpenOrBehindPickets) {
  for (const map::Barrier& barrier : town_with_yards(made_town(CountryGroup::kNorthAmerica)).barriers) {
    if (barrier.kind != BarrierKind::kFence || barrier.fence == map::FenceKind::kPickets) continue;
    for (const Vec2 p : barrier.axis) EXPECT_GT(p.y, 12.9);
  }
}

TEST(AddYards, LotsAtACornerHaveTheSameBarrierAlongBothStreets) {
  map::Features features = made_town(CountryGroup::kBritishIsles, 7);
  features.tracks[0].axis = {{-150, 0}, {80, 0}, {150, 0}}, features.tracks[0].node_ids = {100, 101, 102};
  features.tracks.push_back(street(2, {{80, 0}, {80, 120}}));
  features.tracks.back().node_ids = {101, 201};
  double along_side_street_m = 0;
  for (const map::Barrier& barrier : town_with_yards(std::move(features)).barriers)
    for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i) {
      const Vec2 a = barrier.axis[i], b = barrier.axis[i + 1];
      if (std::min(a.x, b.x) < 73 && std::max(a.y, b.y) > 6) continue;
      along_side_street_m += distance(a, b);
      EXPECT_LE(barrier.height_m, 1) << a.y << ' ' << b.y;
    }
  EXPECT_GT(along_side_street_m, 10);
}

TEST(AddYards, PlantsKeepClearOfWallsWaysWiresAndCrossings) {
  map::Features town = made_town();
  town.tracks.push_back(street(2, {{0, 0}, {0, -150}}));
  town.tracks[0].axis = {{-150, 0}, {0, 0}, {150, 0}};
  town.power_lines.push_back({.id = {{OsmType::kWay, 70}, 0}, .axis = {{-150, 32}, {150, 32}}, .corridor_m = 4});
  town = town_with_yards(std::move(town));
  int plants = 0;
  for (const map::PointFeature& point : town.points) {
    if (point.kind != map::PointKind::kTree) continue;
    ++plants;
    EXPECT_TRUE(is_of_yard(point.id));
    for (const map::Footprint& f : town.footprints) {
      EXPECT_FALSE(contains(f.polygon, point.at));
      EXPECT_GE(distance_to_ring(f.polygon.outer, point.at), 2);
    }
    EXPECT_GE(point.at.y, 6);
    EXPECT_GE(std::abs(point.at.y - 32), 2 + kClearOfWires_m - 0.01);
    EXPECT_GE(length(point.at), kSight_m);
    for (const LandCoverClass c : {LandCoverClass::kYardPath, LandCoverClass::kDrive})
      EXPECT_FALSE(is_in_any(yard_areas(town, c), point.at));
  }
  EXPECT_GT(plants, 20);
}

TEST(AddYards, WhatIsMappedIsNotAssumed) {
  map::Features town = made_town(CountryGroup::kBritishIsles);
  town.tracks.push_back(path(2, {{-12, 5}, {-12, 13}}));
  town.tracks.push_back(path(3, {{12, 3}, {12, 13}}, LandCoverClass::kServiceRoad));
  town.barriers.push_back({.id = {{OsmType::kWay, 60}, 0},
                           .axis = {{24, 5.5}, {48, 5.5}},
                           .kind = BarrierKind::kWall,
                           .height_m = 1,
                           .width_m = 0.3});
  town.points.push_back({.id = {{OsmType::kNode, 5}, 0}, .at = {60, 30}, .kind = map::PointKind::kTree});
  Report report;
  town = town_with_yards(std::move(town), report, {{OsmType::kWay, 3}});
  const auto of = [](ObjectId id, std::int64_t building) { return is_of_yard(id) && id.osm.id == building; };
  for (const map::AreaFeature& area : town.areas) {
    EXPECT_FALSE(of(area.id, 1003) && area.surface == LandCoverClass::kYardPath);
    EXPECT_FALSE(of(area.id, 1004) && (area.surface == LandCoverClass::kDrive));
  }
  for (const map::Barrier& barrier : town.barriers) {
    if (!is_of_yard(barrier.id)) continue;
    for (const Vec2 p : barrier.axis) EXPECT_FALSE(p.y < 6.5 && p.x > 25 && p.x < 47) << p.x << ' ' << p.y;
  }
  for (const map::PointFeature& point : town.points)
    EXPECT_FALSE(of(point.id, 1006) && point.kind == map::PointKind::kTree && point.height_m == 0);
}

TEST(AddYards, AMappedEntranceKeepsItsDoor) {
  map::Features town = made_town();
  town.points.push_back({.id = {{OsmType::kNode, 9}, 0}, .at = {-18, 13}, .kind = map::PointKind::kEntrance});
  town = town_with_yards(std::move(town));
  for (const map::PointFeature& point : town.points)
    EXPECT_FALSE(point.kind == map::PointKind::kEntrance && is_of_yard(point.id) && point.id.osm.id == 1003);
}

TEST(AddYards, YardsAreMarkedAndCounted) {
  Report report;
  const map::Features town = town_with_yards(made_town(), report);
  EXPECT_EQ(report.assumed(Assumption::kYards), 8u);
  for (const map::Footprint& f : town.footprints) EXPECT_TRUE(has(f.assumed, Assumption::kYards));
  EXPECT_TRUE(std::ranges::is_sorted(town.areas, {}, &map::AreaFeature::id));
  EXPECT_TRUE(std::ranges::is_sorted(town.points, {}, &map::PointFeature::id));
}

TEST(AddYards, DesertsHaveFewerLawns) {
  const auto lawns = [](climate::ClimateClass climate) {
    Report report;
    const map::Features town = town_with_yards(made_town(CountryGroup::kNorthAmerica), report, {}, climate);
    return yard_areas(town, LandCoverClass::kLawn).size();
  };
  EXPECT_LT(lawns(climate::ClimateClass::kBWh), lawns(climate::ClimateClass::kCfb));
}

// A yard depends on the order of nothing, and on no house far away.
TEST(AddYards, YardsDependOnTheirSurroundingsOnly) {
  map::Features town = made_town();
  map::Features reversed = town;
  std::ranges::reverse(reversed.footprints);
  reversed.footprints.push_back(house(2000, {180, 13}, {192, 23}));
  const map::Features a = town_with_yards(town), b = town_with_yards(reversed);
  const auto yard_of = [](const map::Features& features, std::int64_t building) {
    std::vector<std::pair<ObjectId, Ring>> all;
    for (const map::AreaFeature& area : features.areas)
      if (is_of_yard(area.id) && area.id.osm.id == building) all.emplace_back(area.id, area.polygon.outer);
    for (const map::Barrier& barrier : features.barriers)
      if (barrier.id.osm.id == building) all.emplace_back(barrier.id, barrier.axis);
    for (const map::PointFeature& point : features.points)
      if (point.id.osm.id == building) all.emplace_back(point.id, Ring{point.at});
    return all;
  };
  for (std::int64_t building = 1000; building < 1006; ++building) EXPECT_EQ(yard_of(a, building), yard_of(b, building));
}

}  // namespace
}  // namespace citykiln::lots
