#include "compiler/furniture/front_things.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;

ground::LandCoverPolygon front_cover(std::int64_t id, const Box2& box, LandCoverClass surface) {
  return {{{OsmType::kWay, id}, 0}, surface, 0, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// Shops along y = 0 that face south to a pavement of a given width, and a street beyond it.
std::vector<things::Thing> before_shops(map::FrontKind kind, double pavement_m, std::uint64_t seed = 1) {
  const std::vector<ground::LandCoverPolygon> cover = {
      front_cover(7, {{0, -pavement_m - 6}, {400, -pavement_m}}, LandCoverClass::kResidentialRoad),
      front_cover(7, {{0, -pavement_m}, {400, 0}}, LandCoverClass::kPavement),
      front_cover(8, {{0, 0}, {400, 12}}, LandCoverClass::kBuilding)};
  std::vector<buildings::Building> shops(1);
  shops[0].id = {{OsmType::kWay, 8}, 0};
  shops[0].footprint.outer = {{0, 0}, {400, 0}, {400, 12}, {0, 12}};
  for (double at_m = 0; at_m < 390; at_m += 10)
    shops[0].fronts.push_back({.edge = 0, .from_m = at_m, .to_m = at_m + 9, .kind = kind});
  const Box2 box{{-16, -32}, {416, 32}};
  const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
  const roadside::TileRecipes recipes{.roads = {},
                                      .junctions = {},
                                      .yards = {},
                                      .pitches = {},
                                      .trunks = {},
                                      .things = {},
                                      .lamps = {},
                                      .barriers = {},
                                      .buildings = shops,
                                      .land_cover = index,
                                      .tile_m = 1024};
  return front_things(recipes, roadside::clear_zones_of(recipes), {}, seed, box);
}

TEST(FrontThings, StandBeforeTheWallAndLeaveRoomToWalk) {
  constexpr double kPavement_m = 3;
  const std::vector<things::Thing> things = before_shops(map::FrontKind::kCafe, kPavement_m);
  EXPECT_GT(things.size(), 10u);
  for (const things::Thing& thing : things) {
    const Box2 box = box_of(roadside::plan_of(thing));
    EXPECT_LE(box.max.y, -0.1);
    EXPECT_GE(box.min.y, -kPavement_m + kWalkBeforeFront_m - 0.05);
    EXPECT_EQ(thing.form.kind, "cafe_table");
  }
}

TEST(FrontThings, AreLargerWherePavementsAreBroadAndNoneWhereTheyAreNarrow) {
  std::set<std::string> kinds;
  for (const things::Thing& thing : before_shops(map::FrontKind::kCafe, 6)) kinds.insert(thing.form.kind);
  EXPECT_TRUE(kinds.contains("parasol_table"));
  EXPECT_TRUE(before_shops(map::FrontKind::kCafe, 1.8).empty());
  EXPECT_TRUE(before_shops(map::FrontKind::kBank, 6).empty());
}

TEST(FrontThings, LeaveTheMiddleOfBroadFrontsToTheDoor) {
  for (const things::Thing& thing : before_shops(map::FrontKind::kFood, 5)) {
    const double from_m = thing.at.x - 10 * static_cast<int>(thing.at.x / 10);
    EXPECT_GE(std::abs(from_m - 4.5) - thing.form.width_m / 2, 1.0) << thing.at.x;
  }
}

}  // namespace
}  // namespace citykiln::furniture
