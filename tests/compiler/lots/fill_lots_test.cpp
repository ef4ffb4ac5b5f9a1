#include "compiler/lots/fill_lots.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "compiler/lots/house_room.h"
#include "tests/compiler/lots/made_town.h"
#include "tests/test_files.h"

namespace citykiln::lots {
namespace {

using map::CountryGroup;

HouseRules shipped_house_rules() {
  Result<HouseRules> rules = read_house_rules([](const std::string& file) -> Result<std::string> {
    std::ifstream in(source_file("grammars/rules/" + file));
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  });
  EXPECT_TRUE(rules);
  return rules ? *rules : HouseRules{};
}

map::Features filled(map::Features features, Report& report) {
  const std::vector<roads::Road> roads = roads::roads_on_ground(features, report);
  const ClimateAt climate_at = [](Vec2) { return climate::ClimateClass::kCfb; };
  features.footprints =
      with_houses(features, {.roads = roads, .junctions = {}, .private_ways = {}, .climate_at = climate_at, .seed = 1},
                  shipped_house_rules(), report);
  return features;
}
map::Features filled(map::Features features) {
  Report report;
  return filled(std::move(features), report);
}

std::vector<map::Footprint> houses_of(const map::Features& features) {
  std::vector<map::Footprint> houses;
  for (const map::Footprint& f : features.footprints)
    if (f.id.osm.type == OsmType::kLot) houses.push_back(f);
  return houses;
}

// The made town with a street of another group.
map::Features town_of(CountryGroup country, int houses = 0) {
  map::Features town = made_town(country, houses);
  for (map::Track& track : town.tracks) track.country = country;
  return town;
}

TEST(FillLots, ResidentialLandWithoutBuildingsGetsHousesInEveryGroup) {
  for (int i = 0; i < static_cast<int>(CountryGroup::kCount); ++i) {
    const auto houses = houses_of(filled(town_of(static_cast<CountryGroup>(i))));
    EXPECT_GE(houses.size(), 8u) << map::name_of(static_cast<CountryGroup>(i));
    for (const map::Footprint& house : houses) {
      EXPECT_GE(signed_area_m2(house.polygon.outer), 15);
      EXPECT_GE(house.levels, 1);
      EXPECT_TRUE(has(house.assumed, Assumption::kHouses));
      for (const Vec2 p : house.polygon.outer) EXPECT_GE(std::abs(p.y), 5.25) << "on the pavement";
    }
  }
}

TEST(FillLots, OtherLandGetsNone) {
  map::Features town = town_of(CountryGroup::kCentralEurope);
  town.areas[0].surface = map::LandCoverClass::kIndustrial;
  EXPECT_TRUE(houses_of(filled(town)).empty());
  town.areas[0].surface = map::LandCoverClass::kPark;
  EXPECT_TRUE(houses_of(filled(town)).empty());
  town.areas.clear();
  EXPECT_FALSE(houses_of(filled(town)).empty()) << "beside a residential street";
  town.tracks[0].surface = map::LandCoverClass::kTertiaryRoad;
  EXPECT_TRUE(houses_of(filled(town)).empty());
}

TEST(FillLots, NoneStandsOnWhatIsMapped) {
  map::Features town = town_of(CountryGroup::kCentralEurope, 8);
  town.tracks.push_back(path(2, {{-100, -30}, {100, -18}}));
  town.areas.push_back(land(60, {20, -60}, {80, -5}, map::LandCoverClass::kPark));
  const auto houses = houses_of(filled(town));
  EXPECT_GE(houses.size(), 3u);
  for (const map::Footprint& house : houses)
    for (const Vec2 p : house.polygon.outer) {
      EXPECT_FALSE(p.x > 20 && p.x < 80 && p.y > -60 && p.y < -5);
      EXPECT_TRUE(std::abs(p.x) > 100 || std::abs(p.y - (-24 + 0.06 * p.x)) >= 2);
      for (const map::Footprint& mapped : town.footprints) EXPECT_FALSE(contains(mapped.polygon, p));
    }
}

TEST(FillLots, HousesOfOneLotHaveItsIdAndTheirOrderDoesNotMatter) {
  map::Features town = town_of(CountryGroup::kBritishIsles);
  town.tracks.push_back(street(2, {{0, 0}, {0, 150}}));
  map::Features other = town;
  std::ranges::reverse(other.tracks);
  const auto a = houses_of(filled(town)), b = houses_of(filled(other));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].polygon, b[i].polygon);
    if (i > 0) {
      EXPECT_LT(a[i - 1].id, a[i].id);
    }
  }
}

TEST(FillLots, TheyGetYards) {
  Report report;
  map::Features town = filled(town_of(CountryGroup::kNorthAmerica), report);
  const std::size_t houses = houses_of(town).size();
  town = town_with_yards(std::move(town), report);
  EXPECT_EQ(report.assumed(Assumption::kHouses), houses);
  EXPECT_GE(report.assumed(Assumption::kYards), houses / 2);
}

TEST(HouseRoom, KeepsItsDistancesFromTheBorder) {
  const Frame frame{{0, 0}, {1, 0}, {0, 1}};
  const Polygon lot{.outer = rectangle({-10, 0}, {12, 30}), .holes = {}};
  const auto room = room_for_house(lot, frame, {.setback_m = 5, .beside_m = 3, .most_width_m = 40, .most_depth_m = 12});
  ASSERT_TRUE(room);
  EXPECT_EQ(*room, (Box2{{-7, 5}, {9, 17}}));
  const auto deep = room_for_house(lot, frame, {.setback_m = 5, .beside_m = 3, .most_width_m = 8, .most_depth_m = 90});
  EXPECT_EQ(*deep, (Box2{{-3, 5}, {5, 26.5}}));
  EXPECT_FALSE(room_for_house({.outer = rectangle({-4, 0}, {4, 30}), .holes = {}}, frame,
                              {.setback_m = 5, .beside_m = 3, .most_width_m = 40, .most_depth_m = 12}));
}

TEST(HouseRoom, AvoidsNotchesAndHoles) {
  const Frame frame{{0, 0}, {1, 0}, {0, 1}};
  const Polygon notched{.outer = {{-10, 0}, {10, 0}, {10, 12}, {4, 12}, {4, 13}, {10, 13}, {10, 30}, {-10, 30}},
                        .holes = {}};
  const auto room =
      room_for_house(notched, frame, {.setback_m = 2, .beside_m = 0, .most_width_m = 40, .most_depth_m = 25});
  ASSERT_TRUE(room);
  EXPECT_LE(room->max.x, 4);
  // between two steps
  const Polygon thin{.outer = {{-10, 0}, {10, 0}, {10, 12.1}, {4, 12.1}, {4, 12.3}, {10, 12.3}, {10, 30}, {-10, 30}},
                     .holes = {}};
  const auto above =
      room_for_house(thin, frame, {.setback_m = 2, .beside_m = 0, .most_width_m = 40, .most_depth_m = 25});
  ASSERT_TRUE(above);
  EXPECT_LE(above->max.y, 12.1);
  const Polygon holed{.outer = rectangle({-10, 0}, {10, 30}), .holes = {{{2, 8}, {2, 12}, {6, 12}, {6, 8}}}};
  const auto beside =
      room_for_house(holed, frame, {.setback_m = 2, .beside_m = 0, .most_width_m = 40, .most_depth_m = 25});
  ASSERT_TRUE(beside);
  EXPECT_LE(beside->max.x, 2);
}

TEST(HouseRoom, TheFirstEdgeOfARectangleIsAlongTheStreetOnBothSides) {
  for (const double side : {1.0, -1.0}) {
    const Frame frame{{0, 0}, {1, 0}, {0, side}};
    const Polygon plan = plane_rectangle(frame, {{1, 2}, {5, 8}});
    EXPECT_EQ(signed_area_m2(plan.outer), 24);
    EXPECT_EQ(frame.local(plan.outer[0]).y, 2);
    EXPECT_EQ(frame.local(plan.outer[1]).y, 2);
  }
}

}  // namespace
}  // namespace citykiln::lots
