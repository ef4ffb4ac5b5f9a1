// Cases of blocks and lots that are drawn by hand.
#include "compiler/parcels/divide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/compiler/parcels/made_land.h"

namespace citykiln::parcels {
namespace {

// A square of streets from 0 to `side_m` in an extent that reaches 40 m farther.
Land square(double side_m) {
  Land land;
  land.extent = {{-40, -40}, {side_m + 40, side_m + 40}};
  land.lines = {street(1, {{0, 0}, {side_m, 0}}), street(2, {{side_m, 0}, {side_m, side_m}}),
                street(3, {{side_m, side_m}, {0, side_m}}), street(4, {{0, side_m}, {0, 0}})};
  return land;
}

Parcels divided(const Land& land) {
  Parcels parcels = divide(land, 1);
  expect_properties(land, parcels, "case");
  return parcels;
}

const Lot* lot_of(const Parcels& parcels, std::uint32_t footprint) {
  for (const Lot& lot : parcels.lots)
    if (std::ranges::count(lot.footprints, footprint)) return &lot;
  return nullptr;
}

std::vector<const Block*> inner_blocks(const Parcels& parcels) {
  std::vector<const Block*> blocks;
  for (const Block& block : parcels.blocks)
    if (!block.is_at_extent) blocks.push_back(&block);
  return blocks;
}

double area_of_blocks(const std::vector<const Block*>& blocks) {
  return std::accumulate(blocks.begin(), blocks.end(), 0.0,
                         [](double a, const Block* b) { return a + area_m2(b->polygon); });
}

TEST(Divide, ABlockIsInsetByItsStreets) {
  const Parcels parcels = divided(square(100));
  const auto blocks = inner_blocks(parcels);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_DOUBLE_EQ(area_m2(blocks[0]->polygon), 92 * 92);
  for (const Border& border : blocks[0]->borders[0]) {
    EXPECT_EQ(border.kind, BorderKind::kLine);
    EXPECT_EQ(border.side, Side::kLeft);
  }
  EXPECT_EQ(parcels.blocks.size(), 2u);  // the other one is about the square, up to the extent
}

TEST(Divide, ADeadEndBoundsNoBlockAndGivesAccess) {
  Land land = square(200);
  land.lines.push_back(street(5, {{100, 0}, {100, 100}}));
  land.footprints = {house(1, 110, 70), house(2, 80, 70)};
  const Parcels parcels = divided(land);
  ASSERT_EQ(inner_blocks(parcels).size(), 1u);
  // the end is round
  EXPECT_NEAR(area_of_blocks(inner_blocks(parcels)), 192.0 * 192 - 96 * 8 - 25, 1);
  EXPECT_EQ(lot_of(parcels, 0)->frontage.line, 4u);
  EXPECT_EQ(lot_of(parcels, 0)->frontage.side, Side::kRight);
  EXPECT_EQ(lot_of(parcels, 1)->frontage.side, Side::kLeft);
}

TEST(Divide, ALoopIsABlockWithinABlock) {
  Land land = square(300);
  land.lines.push_back(street(5, {{130, 130}, {170, 130}, {170, 170}, {130, 170}, {130, 130}}));
  const Parcels parcels = divided(land);
  const auto blocks = inner_blocks(parcels);
  ASSERT_EQ(blocks.size(), 2u);
  // the outer corners are round
  EXPECT_NEAR(area_of_blocks(blocks), 292.0 * 292 - 48 * 48 + 32 * 32 + 15, 1);
  EXPECT_EQ(blocks[0]->polygon.holes.size() + blocks[1]->polygon.holes.size(), 1u);
}

TEST(Divide, TheExtentsEdgeGivesNoAccess) {
  Land land;
  land.extent = {{0, 0}, {100, 100}};
  land.footprints = {house(1, 40, 40)};
  const Parcels parcels = divided(land);
  ASSERT_EQ(parcels.blocks.size(), 1u);
  EXPECT_DOUBLE_EQ(area_m2(parcels.blocks[0].polygon), 100 * 100);
  EXPECT_TRUE(parcels.lots.empty());
  ASSERT_EQ(parcels.failures.size(), 1u);
  EXPECT_EQ(parcels.failures[0].cause, Cause::kFarFromStreet);
}

TEST(Divide, DualCarriagewaysEncloseABlock) {
  Land land;
  land.extent = {{0, 0}, {200, 100}};
  land.lines = {street(1, {{-50, 40}, {250, 40}}), street(2, {{-50, 60}, {250, 60}})};
  const Parcels parcels = divided(land);
  ASSERT_EQ(parcels.blocks.size(), 3u);
  EXPECT_DOUBLE_EQ(area_m2(parcels.blocks[1].polygon), 200 * 12);
}

TEST(Divide, StripsThatOverlapLeaveNoSlivers) {
  Land land;
  land.extent = {{0, 0}, {200, 100}};
  land.lines = {street(1, {{-50, 40}, {250, 40}}), street(2, {{-50, 48.0009765625}, {250, 48.0009765625}})};
  EXPECT_EQ(divided(land).blocks.size(), 2u);
}

TEST(Divide, TerracesHaveLotsAsWideAsTheHouses) {
  Land land = square(120);
  for (std::uint64_t i = 0; i < 5; ++i) land.footprints.push_back(house(i, 30 + 6.0 * static_cast<double>(i), 8, 6, 9));
  const Parcels parcels = divided(land);
  EXPECT_EQ(parcels.lots.size(), 5u);
  for (std::uint32_t i = 1; i < 4; ++i) EXPECT_NEAR(lot_of(parcels, i)->frontage.length_m, 6, 0.01);
}

TEST(Divide, BordersLieHalfwayAndSquareToTheStreet) {
  Land land = square(120);
  land.footprints = {house(1, 30, 8), house(2, 56, 8)};
  const Parcels parcels = divided(land);
  const Lot* lot = lot_of(parcels, 0);
  ASSERT_NE(lot, nullptr);
  const Box2 box = box_of(lot->polygon.outer);
  EXPECT_NEAR(box.max.x, 48, 0.01);
  EXPECT_NEAR(box.min.x, 12, 0.01);  // a usual frontage of 18 m beside the house
  EXPECT_EQ(lot->frontage.line, 0u);
  EXPECT_NEAR(lot->frontage.to.at_m, 48, 0.01);
}

TEST(Divide, AShedBelongsToTheHouseBeforeIt) {
  Land land = square(120);
  land.footprints = {house(1, 30, 8), house(2, 32, 30, 4, 4), house(3, 56, 8)};
  const Parcels parcels = divided(land);
  EXPECT_EQ(lot_of(parcels, 0), lot_of(parcels, 1));
  EXPECT_NE(lot_of(parcels, 0), lot_of(parcels, 2));
}

TEST(Divide, AShedInAGapIsNotCut) {
  Land land = square(120);
  land.footprints = {house(1, 30, 8), house(2, 45, 9, 4, 6), house(3, 56, 8)};
  const Parcels parcels = divided(land);
  ASSERT_NE(lot_of(parcels, 1), nullptr);
  EXPECT_NEAR(box_of(lot_of(parcels, 0)->polygon.outer).max.x, 48, 3.1);
  // the border is one straight line
  const Ring& ring = lot_of(parcels, 0)->polygon.outer;
  EXPECT_EQ(std::ranges::count_if(ring, [](Vec2 p) { return p.x > 44.5; }), 2);
}

TEST(Divide, ABuildingOverTwoBlocksIsInOneLot) {
  Land land = square(100);
  land.lines.push_back(street(5, {{50, 0}, {50, 100}}));
  land.footprints = {house(1, 30, 20, 50, 10)};
  const Parcels parcels = divided(land);
  ASSERT_NE(lot_of(parcels, 0), nullptr);
  EXPECT_TRUE(parcels.failures.empty());
  EXPECT_GT(box_of(lot_of(parcels, 0)->polygon.outer).min.x, 50);
}

TEST(Divide, ABuildingOnAStreetHasNoLot) {
  Land land = square(100);
  land.footprints = {house(1, 30, -3, 6, 6)};
  const Parcels parcels = divided(land);
  ASSERT_EQ(parcels.failures.size(), 1u);
  EXPECT_EQ(parcels.failures[0].cause, Cause::kOnLine);
}

TEST(Divide, ABuildingInAParkHasNoLot) {
  Land land = square(100);
  land.taken = {{rectangle(20, 20, 40, 40), {}}};
  land.footprints = {house(1, 30, 30)};
  const Parcels parcels = divided(land);
  ASSERT_EQ(parcels.failures.size(), 1u);
  EXPECT_EQ(parcels.failures[0].cause, Cause::kOnTaken);
  EXPECT_DOUBLE_EQ(area_of_blocks(inner_blocks(parcels)), 92 * 92 - 40 * 40);
}

TEST(Divide, ARailwayBoundsALotAndGivesNoAccess) {
  Land land;
  land.extent = {{0, 0}, {200, 100}};
  land.lines = {street(1, {{-50, 10}, {250, 10}}), street(2, {{-50, 50}, {250, 50}}, LineKind::kBarrier)};
  land.footprints = {house(1, 50, 20), house(2, 50, 60)};
  const Parcels parcels = divided(land);
  ASSERT_NE(lot_of(parcels, 0), nullptr);
  EXPECT_LE(box_of(lot_of(parcels, 0)->polygon.outer).max.y, 46);
  ASSERT_EQ(parcels.failures.size(), 1u);
  EXPECT_EQ(parcels.failures[0].footprint, 1u);
}

TEST(Divide, BacksOfLotsMeetHalfwayBetweenStreets) {
  Land land = square(80);
  land.footprints = {house(1, 30, 8), house(2, 30, 62)};
  const Parcels parcels = divided(land);
  EXPECT_NEAR(box_of(lot_of(parcels, 0)->polygon.outer).max.y, 40, 0.01);
  EXPECT_NEAR(box_of(lot_of(parcels, 1)->polygon.outer).min.y, 40, 0.01);
}

TEST(Divide, BrokenInputIsLeftOut) {
  Land land = square(100);
  land.lines.push_back(street(5, {}));
  land.lines.push_back(street(6, {{50, 50}}));
  land.lines.push_back(street(7, {{50, 50}, {50, 50}}));
  land.taken.push_back({});
  land.footprints = {{StableId{1}, {}}, {StableId{2}, {{20, 20}, {30, 20}}}};
  const Parcels parcels = divided(land);
  ASSERT_EQ(parcels.failures.size(), 2u);
  EXPECT_EQ(parcels.failures[0].cause, Cause::kWithoutArea);
}

}  // namespace
}  // namespace citykiln::parcels
