#include "compiler/buildings/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/part_outlines.h"

namespace citykiln::buildings {
namespace {

using materials::Material;

// A plane that rises to the east by 1 : 4, 100 m at x = 0.
map::Heightfield slope() {
  map::Heightfield field{{-64, -64}, {16, 16}, 17, 17, {}, 0};
  for (int j = 0; j < 17; ++j)
    for (int i = 0; i < 17; ++i)
      field.heights.push_back(static_cast<std::int32_t>((100 + (i * 16 - 64) / 4.0) / map::kHeightQuantum_m));
  return field;
}

map::Footprint square_block(std::int64_t id, double x, double y, double size, double height_m) {
  map::Footprint f;
  f.id = {{OsmType::kWay, id}, 0};
  f.polygon.outer = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  f.height_m = height_m;
  f.has_roof_in_height = true;
  return f;
}

map::Features features_of(std::vector<map::Footprint> footprints) {
  map::Features f;
  f.extent = {{-128, -128}, {128, 128}};
  f.footprints = std::move(footprints);
  const std::vector<std::uint32_t> outlines = map::part_outlines(f.footprints);
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (outlines[i] != map::kNoOutline) f.footprints[i].outline = f.footprints[outlines[i]].id;
  return f;
}

TEST(Plan, ABuildingBelongsToTheRegionByItsCentroid) {
  Report report;
  // mostly inside, mostly outside; a part that lies outside, of the first outline
  map::Footprint inside = square_block(1, 90, 0, 60, 12), outside = square_block(2, 120, 80, 40, 12),
                 part = square_block(3, 130, 10, 10, 30);
  part.is_part = true;
  const auto b = plan(features_of({inside, outside, part}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 2u);
  EXPECT_EQ(b[0].id.osm.id, 1);
  EXPECT_EQ(b[1].id.osm.id, 3);
  EXPECT_EQ(report.ledger().at("buildings/footprint").dropped.at(Code::kOutsideBounds), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, CountsHeightsFromTheLowestCorner) {
  Report report;
  const auto b = plan(features_of({square_block(1, 0, 0, 8, 12)}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_EQ(b[0].top_m, 112);
  EXPECT_LT(b[0].bottom_m, 100);
  EXPECT_TRUE(b[0].stands_on_ground);
}

TEST(Plan, PutsUnsupportedBuildingsOnPosts) {
  Report report;
  map::Footprint hovering = square_block(1, 0, 0, 20, 18);
  hovering.min_height_m = 9;
  const auto b = plan(features_of({hovering}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_FALSE(b[0].stands_on_ground);
  EXPECT_EQ(b[0].bottom_m, 109);
  EXPECT_EQ(b[0].posts.size(), 16u);  // four corners, three on each edge of 20 m
  EXPECT_LT(b[0].post_foot_m, 100);
  EXPECT_EQ(report.counts()[Code::kUnsupportedBuilding], 1u);
}

TEST(Plan, ARoofWithoutWallsIsASlabOnPosts) {
  Report report;
  map::Footprint roof = square_block(1, 0, 0, 16, 12);
  roof.is_open = true;
  const auto b = plan(features_of({roof}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_FALSE(b[0].stands_on_ground);
  EXPECT_EQ(b[0].top_m, 112);
  EXPECT_EQ(b[0].bottom_m, 111.75);
  EXPECT_EQ(b[0].style, Style::kPlain);
  EXPECT_EQ(b[0].posts.size(), 12u);
  for (const Vec2 post : b[0].posts) EXPECT_TRUE(contains(roof.polygon, post));
  EXPECT_EQ(report.counts()[Code::kUnsupportedBuilding], 0u);
}

TEST(Plan, APitchedRoofWithoutWallsKeepsItsForm) {
  Report report;
  map::Footprint roof = square_block(1, 0, 0, 16, 12);
  roof.is_open = roof.has_roof_shape = true;
  roof.roof.form = roofs::RoofForm::kGabled, roof.roof.height_m = 3;
  const auto b = plan(features_of({roof}), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(b[0].roof_shape.form, roofs::RoofForm::kGabled);
  EXPECT_EQ(eaves_m(b[0]), 109);
  EXPECT_EQ(b[0].bottom_m, 108.75);
}

TEST(Plan, ATaggedRoofMayLeaveNoWall) {
  map::Heightfield level = slope();
  for (std::int32_t& z : level.heights) z = 0;
  Report report;
  map::Footprint house = square_block(1, 0, 0, 8, 6);
  house.has_roof_shape = true, house.roof.form = roofs::RoofForm::kGabled, house.roof.height_m = 8;
  const auto b = plan(features_of({house}), ground::GradedTerrain(std::move(level)), report);
  EXPECT_EQ(b[0].top_m, 6);
  EXPECT_EQ(report.counts()[Code::kHeightRaised], 0u);
}

TEST(Plan, CountsPartsFromTheirOutlinesLowestCorner) {
  Report report;
  map::Footprint outline = square_block(1, 0, 0, 40, 12), part = square_block(2, 30, 0, 10, 30),
                 far = square_block(3, 60, 0, 10, 30);
  outline.has_parts = true;
  part.is_part = far.is_part = true;
  const auto b = plan(features_of({outline, part, far}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 2u);
  EXPECT_EQ(b[0].top_m, 130);
  EXPECT_EQ(b[1].top_m, 145);
  EXPECT_EQ(report.counts()[Code::kOutlineReplacedByParts], 1u);
  EXPECT_EQ(report.ledger().at("buildings/footprint").merged, 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, BelongsToTheSmallestOutlineAround) {
  Report report;
  map::Footprint part = square_block(9, 42, 2, 4, 20);
  part.is_part = true;
  const auto b = plan(features_of({square_block(1, 0, 0, 60, 5), square_block(2, 40, 0, 10, 5), part}),
                      ground::GradedTerrain(slope()), report);
  EXPECT_EQ(b[2].top_m, 130);
}

TEST(Plan, LiftsPartsByTheirMinHeight) {
  Report report;
  map::Footprint part = square_block(2, 0, 0, 10, 30);
  part.is_part = true;
  part.min_height_m = 12;
  const auto b = plan(features_of({square_block(1, 0, 0, 10, 12), part}), ground::GradedTerrain(slope()), report);
  EXPECT_FALSE(b[1].stands_on_ground);
  EXPECT_EQ(b[1].bottom_m, 112);
}

TEST(Plan, RaisesWhatTheSlopeWouldBury) {
  Report report;
  const auto b = plan(features_of({square_block(1, 0, 0, 40, 5)}), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(b[0].top_m, 112);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kHeightRaised);
  EXPECT_EQ(report.diagnoses()[0].size, 7);
}

// A block of storeys of 3 m, without height=*.
map::Footprint storeys(std::int64_t id, double x, double y, double size, double levels) {
  map::Footprint f = square_block(id, x, y, size, levels * 3);
  f.levels = levels, f.has_roof_in_height = false;
  return f;
}

map::Features with_street(map::Features features, double street_x) {
  map::Track street;
  street.id = {{OsmType::kWay, 900}, 0};
  street.axis = {{street_x, -100}, {street_x, 100}};
  street.surface = map::LandCoverClass::kResidentialRoad;
  street.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 5}}, 2.5};
  features.tracks = {street};
  return features;
}

TEST(Plan, NoPostStandsOnAWayOrBesideAWall) {
  Report report;
  map::Footprint roof = square_block(1, 0, 0, 24, 12), house = square_block(2, 24, 0, 24, 20);
  roof.is_open = true;
  const auto b = plan(with_street(features_of({roof, house}), 12), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 2u);
  ASSERT_FALSE(b[0].posts.empty());
  for (const Vec2 post : b[0].posts) {
    EXPECT_GT(std::abs(post.x - 12), 2.5 + 0.125) << post.x;
    EXPECT_LT(post.x, 23.5);
  }
}

// The ground rises from 100 to 105 m below the house.
TEST(Plan, CountsStoreysFromTheStreet) {
  Report report;
  const auto below =
      plan(with_street(features_of({storeys(1, 0, 0, 20, 3)}), -6), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(below[0].floor_m, 100);
  EXPECT_EQ(eaves_m(below[0]), 109);
  const auto above =
      plan(with_street(features_of({storeys(1, 0, 0, 20, 3)}), 26), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(eaves_m(above[0]), 114);
  EXPECT_EQ(report.counts()[Code::kHeightRaised], 0u);
}

TEST(Plan, CountsStoreysFromTheUpperSideWithoutAStreetAndGoesOnBelow) {
  Report report;
  const auto b = plan(features_of({storeys(1, 0, 0, 20, 2)}), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(eaves_m(b[0]), 111);
  // one more storey has a wall above the lowest ground
  EXPECT_EQ(b[0].floor_m, 102);
  EXPECT_EQ(b[0].levels, 3);
  EXPECT_LT(b[0].bottom_m, 100);
  EXPECT_EQ(report.counts()[Code::kHeightRaised], 0u);
}

TEST(Plan, MeasuresAllPartsOfAnOutlineFromOneHeight) {
  Report report;
  map::Footprint outline = storeys(1, 0, 0, 20, 5), low = square_block(2, 0, 0, 10, 9), high = storeys(3, 0, 0, 10, 5);
  outline.has_parts = true;
  low.is_part = high.is_part = true;
  high.min_height_m = 9;
  const auto b = plan(features_of({outline, low, high}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 2u);
  EXPECT_EQ(b[0].top_m, 109);
  EXPECT_EQ(b[1].bottom_m, 109);
}

TEST(Plan, LongWallsAlongASlopeBeginStoreyByStorey) {
  Report report;
  const auto b = plan(features_of({storeys(1, 0, 0, 40, 6)}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 1u);
  std::vector<std::uint8_t> up;
  for (const BuriedFrom& place : b[0].buried_from)
    if (place.edge == 0) up.push_back(place.storeys);
  EXPECT_EQ(b[0].facade_edges[0].buried_storeys, 0);
  EXPECT_EQ(up, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(b[0].facade_edges[1].buried_storeys, 3);
  EXPECT_EQ(b[0].facade_edges[2].buried_storeys, 3);
}

TEST(Plan, StoreysBelowTheEntranceDoNotMakeABlockOfAVilla) {
  Report report;
  map::Footprint house = storeys(1, 0, 0, 12, 2);
  house.polygon.outer = {{0, 0}, {32, 0}, {32, 6}, {0, 6}};
  const auto b = plan(features_of({house}), ground::GradedTerrain(slope()), report);
  EXPECT_GT(b[0].levels, 3);
  EXPECT_EQ(b[0].style, Style::kVilla);
}

TEST(Plan, IgnoresAMinHeightAboveTheHeight) {
  Report report;
  map::Footprint f = square_block(1, 0, 0, 8, 12);
  f.min_height_m = 15;
  const auto b = plan(features_of({f}), ground::GradedTerrain(slope()), report);
  EXPECT_TRUE(b[0].stands_on_ground);
  EXPECT_LT(b[0].bottom_m, b[0].top_m);
  EXPECT_EQ(report.counts()[Code::kMinHeightNotBelowHeight], 1u);
}

TEST(Plan, DoesNotDependOnTheOrderOfFootprints) {
  std::vector<map::Footprint> footprints;
  for (int i = 0; i < 40; ++i) {
    footprints.push_back(square_block(i + 1, (i % 8) * 10 - 40, (i / 8) * 10 - 40, 9.3, 4 + i));
    footprints.back().is_part = i % 3 == 0;
  }
  Report one, two;
  const auto a = plan(features_of(footprints), ground::GradedTerrain(slope()), one);
  std::reverse(footprints.begin(), footprints.end());
  EXPECT_EQ(a, plan(features_of(footprints), ground::GradedTerrain(slope()), two));
}

TEST(Plan, PutsHeightsOnTheGrid) {
  Report report;
  const auto b = plan(features_of({square_block(1, 0.3, 0.7, 8, 12.34567)}), ground::GradedTerrain(slope()), report);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_EQ(b[0].top_m, snapped(b[0].top_m));
  EXPECT_EQ(b[0].bottom_m, snapped(b[0].bottom_m));
}

TEST(Plan, DropsWhatHasNoRing) {
  Report report;
  map::Footprint f = square_block(1, 0, 0, 8, 12);
  f.polygon.outer.resize(2);
  EXPECT_TRUE(plan(features_of({f}), ground::GradedTerrain(slope()), report).empty());
  EXPECT_TRUE(report.balances());
}

TEST(BuildingMaterials, DependOnClassAndSize) {
  Report report;
  map::Footprint church = square_block(1, 0, 0, 20, 18), tower = square_block(2, 30, 0, 30, 90),
                 hall = square_block(3, 0, 30, 40, 9), house = square_block(4, 0, 60, 9, 7);
  church.building_class = static_cast<std::uint8_t>(map::BuildingClass::kChurch);
  tower.building_class = static_cast<std::uint8_t>(map::BuildingClass::kOffice);
  hall.building_class = static_cast<std::uint8_t>(map::BuildingClass::kHall);
  house.building_class = static_cast<std::uint8_t>(map::BuildingClass::kHouse);
  const auto b = plan(features_of({church, tower, hall, house}), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(b[0].roof, Material::kSlate);
  EXPECT_EQ(b[1].wall, Material::kGlassFacade);
  EXPECT_EQ(b[1].roof, Material::kFlatRoof);
  EXPECT_EQ(b[2].roof, Material::kMetalRoof);
  EXPECT_EQ(b[3].roof, Material::kRoofTile);
}

TEST(BuildingMaterials, AreLighterForBrightColours) {
  Report report;
  map::Footprint f = square_block(1, 0, 0, 9, 7), glass = square_block(2, 20, 0, 9, 7);
  f.wall_material = Material::kBrick;
  f.wall_colour = map::Srgb{250, 245, 230};
  glass.wall_material = Material::kGlassFacade;
  glass.wall_colour = map::Srgb{200, 220, 255};
  const auto b = plan(features_of({f, glass}), ground::GradedTerrain(slope()), report);
  EXPECT_EQ(b[0].wall, Material::kLightBrick);
  EXPECT_EQ(b[1].wall, Material::kGlassFacade);
}

}  // namespace
}  // namespace citykiln::buildings
