#include "compiler/furniture/yard_things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/contract/derived_id.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;

Ring rectangle_from_to(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

ObjectId house_of(int n) { return {{OsmType::kWay, n + 1}, 0}; }

// A lot of 20 m by 30 m north of a street, whose border is y = 0; a house of 10 m by 8 m stands 6 m behind it.
struct MadeLot {
  lots::Yard yard;
  std::vector<ground::LandCoverPolygon> cover;

  explicit MadeLot(int n) {
    yard = {.building = house_of(n), .country = map::CountryGroup::kBritishIsles, .kind = lots::LotKind::kDetached};
    yard.polygon.outer = rectangle_from_to({0, 0}, {20, 30});
    yard.frame = {.origin = {0, 0}, .heading = lots::kHeadings / 4};
    yard.setback_m = 6;
    yard.strips = {{.is_drive = true, .from = {3, 0}, .to = {3, 6}}};
    yard.borders = {{.first = 0, .count = 4, .place = lots::BorderPlace::kStreet}};
    cover = {{derived_id(yard.building, lots::kPartsOfYard, 0), LandCoverClass::kLawn, 0, {yard.polygon.outer}},
             {yard.building, LandCoverClass::kBuilding, 0, {rectangle_from_to({5, 6}, {15, 14})}}};
  }

  std::vector<things::Thing> things(const Box2& box, const std::vector<Vec2>& trunks = {}) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes recipes{.roads = {},
                                        .junctions = {},
                                        .yards = {&yard, 1},
                                        .plots = {},
                                        .pitches = {},
                                        .trunks = trunks,
                                        .things = {},
                                        .lamps = {},
                                        .barriers = {},
                                        .buildings = {},
                                        .land_cover = index,
                                        .tile_m = 256};
    return yard_things(recipes, roadside::clear_zones_of(recipes), 1, box);
  }
};

constexpr Box2 kLotBox{{-10, -10}, {40, 40}};

// True if a thing's rectangle, widened by a margin, touches a box.
bool reaches(const things::Thing& thing, const Box2& box, double margin_m) {
  const double half_m = std::hypot(thing.form.width_m, thing.form.depth_m) / 2;
  const double x = std::clamp(thing.at.x, box.min.x, box.max.x), y = std::clamp(thing.at.y, box.min.y, box.max.y);
  return distance(thing.at, {x, y}) < std::min(thing.form.width_m, thing.form.depth_m) / 2 + margin_m && half_m > 0;
}

TEST(YardThings, StandInTheirLotBehindTheHouseFront) {
  std::size_t found = 0;
  for (int n = 0; n < 200; ++n)
    for (const things::Thing& thing : MadeLot(n).things(kLotBox)) {
      ++found;
      if (thing.form.kind == things::kYardGate || thing.form.kind == "yard_carport") continue;
      EXPECT_TRUE((Box2{{0, 0}, {20, 30}}.contains(thing.at))) << thing.form.kind;
      EXPECT_FALSE(reaches(thing, {{5, 6}, {15, 14}}, 0)) << thing.form.kind;
      if (thing.form.kind != "wheelie_bins" && thing.form.kind != "yard_garage") {
        EXPECT_GT(thing.at.y, 9) << thing.form.kind;
      }
    }
  EXPECT_GT(found, 200u);
}

TEST(YardThings, ComeInTheShareOfTheirCountry) {
  int sheds = 0;
  for (int n = 0; n < 400; ++n) {
    const auto made = MadeLot(n).things(kLotBox);
    sheds += std::ranges::any_of(made, [](const things::Thing& t) { return t.form.kind == "garden_shed"; }) ? 1 : 0;
  }
  EXPECT_NEAR(sheds / 400.0, 0.55, 0.09) << "less those without a free place";
}

TEST(YardThings, GaragesStandBehindTheDriveAndCarportsOverIt) {
  int garages = 0;
  for (int n = 0; n < 200; ++n) {
    MadeLot lot(n);
    int roofs = 0;
    for (const things::Thing& thing : lot.things(kLotBox)) {
      if (!thing.form.kind.ends_with("garage") && !thing.form.kind.ends_with("carport")) continue;
      const bool is_garage = thing.form.kind == "yard_garage";
      ++roofs, garages += is_garage;
      EXPECT_NEAR(std::abs(thing.at.x), 3, 0.01);
      EXPECT_NEAR(thing.at.y, is_garage ? 9 : 3.375, 0.01);
    }
    EXPECT_LE(roofs, 1);
  }
  EXPECT_NEAR(garages / 200.0, 0.4, 0.1);
}

TEST(YardThings, KeepOffTrunksAndEachOther) {
  const std::vector<Vec2> trunks = {{10, 20}};
  for (int n = 0; n < 100; ++n) {
    const auto made = MadeLot(n).things(kLotBox, trunks);
    for (std::size_t i = 0; i < made.size(); ++i) {
      EXPECT_GT(distance(made[i].at, {10, 20}), 0.75);
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT(distance(made[i].at, made[k].at), 0.75);
    }
  }
}

TEST(YardThings, GatesStandWhereTheDriveLeavesAYardWithAWall) {
  std::set<double> widths;
  int gates = 0;
  for (int n = 0; n < 100; ++n)
    for (const things::Thing& thing : MadeLot(n).things(kLotBox)) {
      if (thing.form.kind != things::kYardGate) continue;
      ++gates, widths.insert(thing.form.width_m);
      EXPECT_NEAR(std::abs(thing.at.x), 3, 0.01);
    }
  EXPECT_GT(gates, 10);
  EXPECT_EQ(widths, std::set<double>{2.75});
}

// A plot of storage of 24 by 22 m on industrial land.
struct MadePlot {
  lots::Yard plot;
  std::vector<ground::LandCoverPolygon> cover;

  explicit MadePlot(int n) {
    plot = {.building = house_of(n), .country = map::CountryGroup::kBritishIsles, .kind = lots::LotKind::kStorage};
    plot.polygon.outer = rectangle_from_to({0, 0}, {24, 22});
    plot.frame = {.origin = {0, 0}, .heading = lots::kHeadings / 4};
    cover = {{house_of(1000), LandCoverClass::kIndustrial, 0, {rectangle_from_to({-100, -100}, {100, 100})}}};
  }

  std::vector<things::Thing> things() const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, kLotBox.widened(48));
    const roadside::TileRecipes recipes{.roads = {},
                                        .junctions = {},
                                        .yards = {},
                                        .plots = {&plot, 1},
                                        .pitches = {},
                                        .trunks = {},
                                        .things = {},
                                        .lamps = {},
                                        .barriers = {},
                                        .buildings = {},
                                        .land_cover = index,
                                        .tile_m = 256};
    return yard_things(recipes, roadside::clear_zones_of(recipes), 1, kLotBox);
  }
};

TEST(YardThings, OfStorageStandInTheirPlotApartFromEachOther) {
  std::size_t found = 0;
  for (int n = 0; n < 60; ++n) {
    const auto made = MadePlot(n).things();
    found += made.size();
    for (std::size_t i = 0; i < made.size(); ++i) {
      EXPECT_TRUE((Box2{{0, 0}, {24, 22}}.contains(made[i].at))) << made[i].form.kind;
      EXPECT_EQ(things::yard_number(made[i].form.kind, things::YardUse::kStorage).most == 0, false);
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT(distance(made[i].at, made[k].at), 1.5);
    }
  }
  EXPECT_GT(found, 180u);
}

TEST(YardThings, OfPlotsKeepOffAllThatIsMappedMoreFinely) {
  MadePlot made(1);
  made.cover.push_back({house_of(1001), LandCoverClass::kPark, 0, {rectangle_from_to({-50, -50}, {50, 50})}});
  EXPECT_TRUE(made.things().empty());
}

TEST(YardThings, BelongToOneTile) {
  for (int n = 0; n < 40; ++n) {
    const std::size_t whole = MadeLot(n).things(kLotBox).size();
    const std::size_t parts =
        MadeLot(n).things({{-10, -10}, {9, 40}}).size() + MadeLot(n).things({{9, -10}, {40, 40}}).size();
    EXPECT_EQ(parts, whole);
  }
}

TEST(YardKinds, AreRowsOfTheTableOfThings) {
  std::set<std::string> names;
  const auto catalogue = things::read_catalogue({}, "");
  ASSERT_TRUE(catalogue);
  for (const map::ThingRow& row : catalogue->table) names.insert(row.name);
  for (const things::YardKind& kind : things::kYardKinds) EXPECT_TRUE(names.contains(kind.name)) << kind.name;
  EXPECT_TRUE(names.contains(std::string(things::kYardGate)));
}

}  // namespace
}  // namespace citykiln::furniture
