#include "compiler/assume/avenues.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::assume {
namespace {

using map::LandCoverClass;

constexpr LonLat kUckermark{13.5, 53.3}, kBavaria{12, 48.5};

map::Track road(std::int64_t id, double y) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = {{0, y}, {150, y}, {300, y}};
  track.node_ids = {id * 10, id * 10 + 1, id * 10 + 2};
  track.surface = LandCoverClass::kTertiaryRoad;
  track.section.lanes = {{.width_m = 3}, {.width_m = 3}};
  track.section.axis_offset_m = 3;
  return track;
}

// 200 roads, 200 m apart, through farmland.
struct Country {
  map::Features map;
  Report report;

  Country() {
    for (int i = 0; i < 200; ++i) map.tracks.push_back(road(i + 1, 200.0 * i));
    map.areas = {{.id = {{OsmType::kWay, 9000}, 0},
                  .polygon = {{{-500, -500}, {800, -500}, {800, 41000}, {-500, 41000}}, {}},
                  .surface = LandCoverClass::kFarmland,
                  .area_m2 = 5e7}};
    map.extent = {{-512, -512}, {1024, 41088}};
  }

  std::vector<map::Track> avenues(LonLat place) {
    std::vector<map::Track> all = assume_avenues(
        map, [&](Vec2) { return place; }, 1, report);
    std::erase_if(all, [](const map::Track& t) { return t.trees == map::TreeSides::kNone; });
    return all;
  }
};

TEST(Avenues, AShareOfTheRoadsOfARegionHasTrees) {
  Country country;
  const std::vector<map::Track> avenues = country.avenues(kUckermark);
  EXPECT_GT(avenues.size(), 55u);
  EXPECT_LT(avenues.size(), 110u);
  EXPECT_EQ(country.report.assumed(Assumption::kRoadsides), avenues.size());
  for (const map::Track& track : avenues) {
    EXPECT_EQ(track.trees, map::TreeSides::kBoth);
    EXPECT_NE(track.tree_kind, map::PlantKind::kUnknown);
    EXPECT_TRUE(has(track.assumed, Assumption::kRoadsides));
  }
  EXPECT_TRUE(Country().avenues(kBavaria).empty());
}

TEST(Avenues, MappedTreesLeaveNone) {
  Country country;
  const std::size_t all = country.avenues(kUckermark).size();
  for (int i = 0; i < 100; ++i)
    country.map.tree_rows.push_back({{{OsmType::kWay, 10000 + i}, 0}, {{100, 200.0 * i + 8}, {200, 200.0 * i + 8}}});
  const std::vector<map::Track> left = country.avenues(kUckermark);
  EXPECT_LT(left.size(), all);
  EXPECT_TRUE(std::ranges::all_of(left, [](const map::Track& t) { return t.axis[0].y >= 20000; }));
}

TEST(Avenues, WoodsAndTownsLeaveNone) {
  Country country;
  country.map.areas[0].surface = LandCoverClass::kForest;
  EXPECT_TRUE(country.avenues(kUckermark).empty());
  country.map.areas[0].surface = LandCoverClass::kResidential;
  EXPECT_TRUE(country.avenues(kUckermark).empty());
}

}  // namespace
}  // namespace citykiln::assume
