#include "compiler/furniture/street_furniture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "compiler/furniture/stations.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/facing.h"
#include "compiler/things/street_kinds.h"

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

ground::LandCoverPolygon cover_of(std::int64_t id, const Box2& box, LandCoverClass surface) {
  return {{{OsmType::kWay, id}, 0}, surface, 0, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// A street along y = 0 with a pavement of 4 m on its left, and houses behind it.
struct MadeStreet {
  std::vector<roads::Road> roads = {street()};
  std::vector<ground::LandCoverPolygon> cover = {cover_of(7, {{0, -3}, {1000, 3}}, LandCoverClass::kResidentialRoad),
                                                 cover_of(7, {{0, 3}, {1000, 7}}, LandCoverClass::kPavement),
                                                 cover_of(8, {{0, 7}, {1000, 20}}, LandCoverClass::kBuilding)};
  std::vector<buildings::Building> buildings{};
  std::vector<things::Thing> things{};
  std::vector<props::StreetLamp> lamps{};

  static roads::Road street() {
    roads::Road road;
    road.id = {{OsmType::kWay, 7}, 0};
    road.axis = {{0, 0}, {1000, 0}};
    road.surface = LandCoverClass::kResidentialRoad;
    road.section.lanes = {{LaneKind::kSidewalk, LaneDirection::kBoth, 4, 0, true},
                          {LaneKind::kDriving, LaneDirection::kBackward, 3},
                          {LaneKind::kDriving, LaneDirection::kForward, 3}};
    road.section.axis_offset_m = 3;  // from the carriageway's left edge
    return road;
  }

  void add_shops() {
    buildings::Building shops;
    shops.id = {{OsmType::kWay, 8}, 0};
    shops.footprint.outer = {{0, 7}, {1000, 7}, {1000, 20}, {0, 20}};
    for (double at_m = 0; at_m < 990; at_m += 10) shops.fronts.push_back({.edge = 0, .from_m = at_m, .to_m = at_m + 8});
    buildings.push_back(shops);
  }

  std::vector<Vec2> trunks{};

  std::vector<things::Thing> furniture(const Box2& box, std::uint64_t seed = 1) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes recipes{.roads = roads,
                                        .junctions = {},
                                        .yards = {},
                                        .plots = {},
                                        .pitches = {},
                                        .trunks = trunks,
                                        .things = things,
                                        .lamps = lamps,
                                        .barriers = {},
                                        .buildings = buildings,
                                        .land_cover = index,
                                        .tile_m = 256};
    return street_furniture(recipes, roadside::clear_zones_of(recipes), seed, box);
  }
};

const Box2 kWholeStreet{{-64, -64}, {1100, 64}};

std::map<std::string, int> counts_of(const std::vector<things::Thing>& pieces) {
  std::map<std::string, int> counts;
  for (const things::Thing& piece : pieces) ++counts[piece.form.kind];
  return counts;
}

TEST(StreetFurniture, StandsInsideTheKerbAndLeavesRoomToWalk) {
  MadeStreet street;
  street.add_shops();
  const std::vector<things::Thing> pieces = street.furniture(kWholeStreet);
  EXPECT_GT(pieces.size(), 20u);
  for (const things::Thing& piece : pieces) {
    const Box2 box = box_of(roadside::plan_of(piece));
    EXPECT_GE(box.min.y, 3 + kBehindKerb_m - 0.02);
    EXPECT_LE(box.max.y, 7 - kFreeWidth_m + 0.02);
  }
}

TEST(StreetFurniture, FacesTheStreetAndSignsTheTraffic) {
  MadeStreet street;
  street.add_shops();
  int signs = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (const things::Thing& piece : street.furniture(kWholeStreet, seed)) {
      const bool is_sign = piece.form.kind == "traffic_sign";
      ++(is_sign ? signs : others);
      // on the left pavement, beside the lane of the other direction
      EXPECT_NEAR(distance(things::unit_vector(piece.direction), is_sign ? Vec2{1, 0} : Vec2{0, -1}), 0, 0.01);
    }
  EXPECT_GT(signs, 10);
  EXPECT_GT(others, 100);
}

// Streets that begin where others end, and one that joins at a right angle, all on one pavement with houses beside it.
MadeStreet pieces_of_a_street() {
  MadeStreet street;
  street.roads.clear();
  for (int i = 0; i < 20; ++i) {
    roads::Road road = MadeStreet::street();
    road.id.osm.id = 100 + i, road.axis = {{50.0 * i, 0}, {50.0 * (i + 1), 0}};
    street.roads.push_back(road);
    road.id.osm.id = 200 + i, road.axis = {{50.0 * i + 20, -20}, {50.0 * i + 20, 5}};
    street.roads.push_back(road);
  }
  street.cover = {cover_of(7, {{0, -40}, {1000, 12}}, LandCoverClass::kPavement),
                  cover_of(8, {{0, 12}, {1000, 20}}, LandCoverClass::kBuilding)};
  return street;
}

TEST(StreetFurniture, OfTwoWaysDoesNotOverlap) {
  const MadeStreet street = pieces_of_a_street();
  std::size_t all = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::vector<things::Thing> pieces = street.furniture(kWholeStreet, seed);
    all += pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = i + 1; j < pieces.size(); ++j)
        EXPECT_FALSE(overlap(roadside::plan_of(pieces[i]), roadside::plan_of(pieces[j]), 0));
  }
  EXPECT_GT(all, 500u);
}

TEST(StreetFurniture, OfTwoWaysIsInOneTileEach) {
  const MadeStreet street = pieces_of_a_street();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    std::vector<Vec2> whole, parts;
    for (const things::Thing& piece : street.furniture(kWholeStreet, seed)) whole.push_back(piece.at);
    for (double x = -64; x < 1100; x += 97)
      for (const things::Thing& piece : street.furniture({{x, -64}, {x + 97, 64}}, seed)) parts.push_back(piece.at);
    std::ranges::sort(whole), std::ranges::sort(parts);
    EXPECT_EQ(parts, whole);
  }
}

TEST(StreetFurniture, KeepsOffTrunks) {
  MadeStreet street;
  street.add_shops();
  for (double x = 0; x < 1000; x += 0.5) street.trunks.push_back({x, 3.6});
  EXPECT_TRUE(street.furniture(kWholeStreet).empty());
}

TEST(StreetFurniture, IsMoreBesideShops) {
  MadeStreet homes, shops;
  shops.add_shops();
  int of_homes = 0, of_shops = 0, benches = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    of_homes += static_cast<int>(homes.furniture(kWholeStreet, seed).size());
    const auto pieces = shops.furniture(kWholeStreet, seed);
    of_shops += static_cast<int>(pieces.size()), benches += counts_of(pieces)["bench"];
  }
  EXPECT_GT(of_shops, 2 * of_homes);
  EXPECT_GT(of_homes, 40 * 5);
  EXPECT_NEAR(benches / 40.0, 9, 2) << "the rate of the table, on one kilometre";
}

TEST(StreetFurniture, IsNowhereInOpenLandAndOnNarrowPavements) {
  MadeStreet open;
  open.cover.pop_back();
  EXPECT_TRUE(open.furniture(kWholeStreet).empty());
  MadeStreet narrow;
  narrow.roads[0].section.lanes[0].width_m = 1;
  EXPECT_TRUE(narrow.furniture(kWholeStreet).empty());
}

TEST(StreetFurniture, IsInOneTileEach) {
  MadeStreet street;
  street.add_shops();
  std::vector<Vec2> whole, parts;
  for (const things::Thing& piece : street.furniture(kWholeStreet)) whole.push_back(piece.at);
  for (double x = -64; x < 1100; x += 194)
    for (const things::Thing& piece : street.furniture({{x, -64}, {x + 194, 64}})) parts.push_back(piece.at);
  std::ranges::sort(whole), std::ranges::sort(parts);
  EXPECT_EQ(parts, whole);
}

TEST(StreetFurniture, IsNotNearMappedPiecesOfItsKindNorInLamps) {
  MadeStreet street;
  street.add_shops();
  for (double x = 0; x < 1000; x += 50) {
    street.things.push_back({.at = {x, 6}, .form = {.kind = "bench"}});
    street.lamps.push_back({.at = {x, 3.5}});
  }
  for (const things::Thing& piece : street.furniture(kWholeStreet)) {
    EXPECT_NE(piece.form.kind, "bench");
    for (const props::StreetLamp& lamp : street.lamps) EXPECT_GE(distance(lamp.at, piece.at), roadside::kFromLamp_m);
  }
}

TEST(StreetKinds, AreRowsOfTheTableOfThings) {
  const Result<things::Catalogue> catalogue = things::read_catalogue({}, "");
  ASSERT_TRUE(catalogue);
  for (const things::StreetKind& kind : things::kStreetKinds) {
    const auto row = std::ranges::find(catalogue->table, kind.name, &map::ThingRow::name);
    ASSERT_NE(row, catalogue->table.end()) << kind.name;
    EXPECT_EQ(row->facing, kind.facing) << kind.name;
    EXPECT_EQ(row->width.default_m, kind.width_m) << kind.name;
    EXPECT_EQ(row->depth.default_m, kind.depth_m) << kind.name;
    EXPECT_EQ(row->height.default_m, kind.height_m) << kind.name;
  }
}

}  // namespace
}  // namespace citykiln::furniture
