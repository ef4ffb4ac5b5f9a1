#include "compiler/parcels/empty_lots.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/parcels/made_land.h"

namespace citykiln::parcels {
namespace {

constexpr LotSize kUsual{.area_m2 = 600, .frontage_m = 18, .depth_m = 40};

TEST(EmptyLots, ASplitIsSquareToTheLongerAxis) {
  const Ring lot = rectangle(0, 0, 40, 25);
  const SplitTree tree = split(lot, {{{0, 0}, {40, 0}}}, kUsual);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_NEAR(tree.nodes[0].at.x, 20, 1e-9);
  EXPECT_NE(leaf_at(tree, {5, 5}), leaf_at(tree, {35, 5}));
  EXPECT_EQ(leaf_at(tree, {5, 5}), leaf_at(tree, {5, 20}));
}

TEST(EmptyLots, APartWithoutAFrontIsNotSplitOff) {
  const Ring lot = rectangle(0, 0, 30, 60);
  const SplitTree tree = split(lot, {{{0, 0}, {30, 0}}}, kUsual);
  ASSERT_FALSE(tree.nodes.empty());
  EXPECT_EQ(leaf_at(tree, {5, 5}), leaf_at(tree, {5, 55}));
  EXPECT_NE(leaf_at(tree, {5, 5}), leaf_at(tree, {25, 5}));
}

TEST(EmptyLots, AUsualLotIsNotSplit) {
  EXPECT_TRUE(split(rectangle(0, 0, 20, 30), {{{0, 0}, {20, 0}}}, kUsual).nodes.empty());
}

TEST(EmptyLots, CutsLieInTheLot) {
  const SplitTree tree = split(rectangle(0, 0, 120, 40), {{{0, 0}, {120, 0}}}, kUsual);
  EXPECT_EQ(tree.cuts.size(), tree.nodes.size());
  for (const auto& [a, b] : tree.cuts) EXPECT_NEAR(distance(a, b), 40, 0.2);
}

Land street_of(double length_m) {
  Land land;
  land.extent = {{0, 0}, {length_m, 60}};
  land.lines = {street(1, {{-100, 4}, {length_m + 100, 4}})};
  land.split_empty = true;
  return land;
}

TEST(EmptyLots, LandWithoutBuildingsBecomesLotsOfUsualSize) {
  const Land land = street_of(400);
  const Parcels parcels = divide(land, 1);
  expect_properties(land, parcels, "street");
  EXPECT_GT(parcels.lots.size(), 15u);
  for (const Lot& lot : parcels.lots) {
    EXPECT_LE(area_m2(lot.polygon), 600 * 1.25 + 1);
    EXPECT_GE(lot.frontage.length_m, 7);
    EXPECT_TRUE(lot.footprints.empty());
  }
}

TEST(EmptyLots, WithoutTheOptionLandStaysFree) {
  Land land = street_of(400);
  land.split_empty = false;
  EXPECT_TRUE(divide(land, 1).lots.empty());
}

TEST(EmptyLots, HousesKeepTheirLots) {
  Land land = street_of(400);
  land.footprints = {house(1, 200, 14)};
  const Parcels split_lots = divide(land, 1);
  expect_properties(land, split_lots, "street");
  land.split_empty = false;
  const Parcels houses = divide(land, 1);
  ASSERT_EQ(houses.lots.size(), 1u);
  const auto same = std::ranges::find(split_lots.lots, houses.lots[0].id, &Lot::id);
  ASSERT_NE(same, split_lots.lots.end());
  EXPECT_NEAR(area_m2(same->polygon), area_m2(houses.lots[0].polygon), 0.1);
  EXPECT_EQ(same->footprints, houses.lots[0].footprints);
}

TEST(EmptyLots, ALongerStreetKeepsTheLotsOfItsStart) {
  const Parcels shorter = divide(street_of(1000), 1), longer = divide(street_of(1600), 1);
  // ids name the whole segment, which is another one
  std::size_t same = 0, far = 0;
  for (const Lot& lot : shorter.lots) {
    if (box_of(lot.polygon.outer).max.x > 1000 - kInfluenceRadius_m) continue;
    ++far;
    same += static_cast<std::size_t>(std::ranges::count(longer.lots, lot.polygon, &Lot::polygon));
  }
  EXPECT_GT(far, 10u);
  EXPECT_EQ(same, far);
}

}  // namespace
}  // namespace citykiln::parcels
