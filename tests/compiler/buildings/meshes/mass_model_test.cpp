#include "compiler/buildings/meshes/mass_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::buildings {
namespace {

using grammars::Face;
using grammars::FaceTag;

// 12 m by 9 m, two storeys of 3 m and a gabled roof of 3 m, 2 m of foundation.
Building gabled_house() {
  Building b;
  b.id = {{OsmType::kWay, 7}, 0};
  b.footprint.outer = {{0, 0}, {12, 0}, {12, 9}, {0, 9}};
  b.bottom_m = 98, b.floor_m = 100, b.top_m = 109;
  b.roof_shape.form = roofs::RoofForm::kGabled, b.roof_shape.height_m = 3;
  b.levels = 2;
  b.facade_edges.resize(4);
  return b;
}

double area_of(const std::vector<Face>& faces, FaceTag tag) {
  double sum = 0;
  for (const Face& face : faces)
    if (face.tag == tag) sum += area_m2(face);
  return sum;
}

MassModel made(const Building& building, double tolerance_m = 0.02) {
  Report report;
  return mass_model_of(building, tolerance_m, report);
}

// Twice the vector area, which is 0 for closed surfaces.
Vec3 sum_of(const std::vector<Face>& faces) {
  Vec3 sum;
  for (const Face& face : faces) sum = sum + double_area_vector_m2(face);
  return sum;
}

TEST(MassModel, HasWallsFromFloorToEaves) {
  const MassModel mass = made(gabled_house());
  ASSERT_EQ(mass.walls.size(), 4u);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kSide), 2 * (12 + 9) * 6);
  EXPECT_EQ(area_of(mass.foundation, FaceTag::kSide), 2 * (12 + 9) * 2);
}

TEST(MassModel, ClosesButForItsFloor) {
  for (const roofs::RoofForm form :
       {roofs::RoofForm::kFlat, roofs::RoofForm::kGabled, roofs::RoofForm::kHipped, roofs::RoofForm::kDome}) {
    Building b = gabled_house();
    b.roof_shape.form = form;
    if (form == roofs::RoofForm::kFlat) b.roof_shape = {}, b.top_m = 106;
    const Vec3 open = sum_of(shape_of(b, made(b)).faces);
    EXPECT_NEAR(open.x, 0, 1e-6);
    EXPECT_NEAR(open.y, 0, 1e-6);
    EXPECT_NEAR(open.z, 2 * 108, 1e-6);
  }
}

TEST(MassModel, HasWallsInTheOrderOfTheFootprintForEveryRoof) {
  Building b = gabled_house();
  b.footprint = {{{9, 0}, {12, 0}, {12, 9}, {0, 9}, {0, 4}, {9, 4}}, {{{10, 5}, {10, 6}, {11, 6}, {11, 5}}}};
  b.facade_edges.resize(6);
  std::vector<Vec2> corners = b.footprint.outer;
  corners.insert(corners.end(), b.footprint.holes[0].begin(), b.footprint.holes[0].end());
  for (const roofs::RoofForm form : {roofs::RoofForm::kFlat, roofs::RoofForm::kGabled, roofs::RoofForm::kHipped})
    for (const double overhang_m : {0.0, 0.5}) {
      b.roof_shape.form = form, b.roof_shape.overhang_m = overhang_m;
      std::vector<Vec2> starts;
      for (const Face& wall : made(b).walls) starts.push_back(in_plan(wall.outer[0]));
      EXPECT_EQ(starts, corners) << static_cast<int>(form) << " " << overhang_m;
    }
}

TEST(MassModel, DistinguishesGablesFromWalls) {
  const grammars::Shape shape = shape_of(gabled_house(), made(gabled_house()));
  EXPECT_NEAR(area_of(shape.faces, FaceTag::kVertical), 2 * 9 * 3 / 2.0, 1e-6);
  EXPECT_GT(area_of(shape.faces, FaceTag::kTop), 108);
}

TEST(MassModel, OmitsHiddenPartyWalls) {
  Building b = gabled_house();
  b.party_walls = {{1, 0, 9, 130, true, false}};
  EXPECT_EQ(area_of(made(b).walls, FaceTag::kSide), (12 + 9 + 12) * 6);
  EXPECT_EQ(area_of(made(b).walls, FaceTag::kInside), 0);
  // coarse levels, which may drop the neighbour, keep it
  EXPECT_EQ(area_of(made(b, 2).walls, FaceTag::kInside), 9 * 6);
}

TEST(MassModel, HasBlindWallsAboveAndBesideNeighbours) {
  Building b = gabled_house();
  b.party_walls = {{1, 0, 9, 104, true, false}, {3, 3, 9, 130, false, false}};
  const MassModel mass = made(b);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kInside), 9 * 2 + 6 * 6);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kSide), (12 + 12 + 3) * 6);
}

TEST(MassModel, HasWindowsAboveOtherPartsOfItsBuilding) {
  Building b = gabled_house();
  b.party_walls = {{1, 0, 9, 104, true, true}};
  EXPECT_EQ(area_of(made(b).walls, FaceTag::kSide), (12 + 9 + 12) * 6 + 9 * 2);
}

TEST(MassModel, StandsOnBuriedStoreys) {
  Building b = gabled_house();
  b.facade_edges[2].buried_storeys = 1;
  b.facade_edges[0].faces_street = true;
  const MassModel mass = made(b);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kSide), (9 + 12 + 9) * 6 + 12 * 3);
  EXPECT_EQ(area_of(mass.foundation, FaceTag::kSide), 2 * (12 + 9) * 2 + 12 * 3);
  for (const Face& wall : mass.walls) EXPECT_EQ(wall.street, wall.outer[0] == (Vec3{0, 0, 100}));
}

TEST(MassModel, BeginsStoreyByStoreyAlongASlope) {
  Building b = gabled_house();
  b.buried_from = {{0, 4, 1}, {0, 8, 2}};
  const MassModel mass = made(b);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kSide), (9 + 12 + 9) * 6 + 4 * 6 + 4 * 3);
  EXPECT_EQ(area_of(mass.foundation, FaceTag::kSide), 2 * (12 + 9) * 2 + 4 * 3 + 4 * 6);
}

TEST(MassModel, BeginsAtTheLowestStoreyOfASlopeWithoutDetail) {
  Building b = gabled_house();
  b.facade_edges[0].buried_storeys = 1, b.buried_from = {{0, 4, 2}, {0, 8, 1}};
  EXPECT_EQ(area_of(made(b).walls, FaceTag::kSide), (9 + 12 + 9) * 6 + 8 * 3);
  EXPECT_EQ(area_of(made(b, 1.5).walls, FaceTag::kSide), (9 + 12 + 9) * 6 + 12 * 3);
}

TEST(MassModel, HasAnUndersideIfLifted) {
  Building b = gabled_house();
  b.stands_on_ground = false, b.bottom_m = b.floor_m = 100;
  const MassModel mass = made(b);
  EXPECT_EQ(area_of(mass.foundation, FaceTag::kBottom), 108);
  std::vector<Face> all = shape_of(b, mass).faces;
  all.insert(all.end(), mass.foundation.begin(), mass.foundation.end());
  EXPECT_NEAR(length(sum_of(all)), 0, 1e-6);
}

TEST(MassModel, MayBeOnlyARoof) {
  Building b = gabled_house();
  b.stands_on_ground = false, b.bottom_m = b.floor_m = 106;
  EXPECT_TRUE(made(b).walls.empty());
  EXPECT_FALSE(made(b).roof.triangles.empty());
}

TEST(MassModel, IsTotalOnAnyRing) {
  Building b = gabled_house();
  b.party_walls = {{1, 0, 9, 104, true, false}};
  for (const Ring& ring : {Ring{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, Ring{{0, 0}, {5, 0}, {10, 0}},
                           Ring{{0, 0}, {0, 9}, {12, 9}, {12, 0}}, Ring{{0, 0}, {12, 0}, {12, 9}, {12, 0}}}) {
    b.footprint.outer = ring;
    EXPECT_NO_FATAL_FAILURE(shape_of(b, made(b)));
  }
}

// Strips of some centimetres above a neighbour's eaves, or beside it, are no faces of their own.
TEST(MassModel, HasNoNarrowStripsAroundPartyWalls) {
  Building b = gabled_house();
  b.party_walls = {{1, 0.125, 8.875, 105.875, true, false}};
  const MassModel mass = made(b);
  EXPECT_EQ(mass.walls.size(), 3u);
  EXPECT_EQ(area_of(mass.walls, FaceTag::kSide), (12 + 9 + 12) * 6);
}

// The longest wall that faces a street, even if others are longer.
TEST(MassModel, HasItsScopeAlongTheStreet) {
  Building b = gabled_house();
  b.facade_edges[1].faces_street = true;
  EXPECT_EQ(shape_of(b, made(b)).scope.axis[0], (Vec3{0, 1, 0}));
  b.facade_edges[1].faces_street = false;
  EXPECT_EQ(std::abs(shape_of(b, made(b)).scope.axis[0].x), 1);
}

TEST(MassModel, IsBuriedToItsEavesAtMost) {
  Building b = gabled_house();
  for (FacadeEdge& front : b.facade_edges) front.buried_storeys = 3;
  const MassModel mass = made(b);
  EXPECT_TRUE(mass.walls.empty());
  EXPECT_EQ(area_of(mass.foundation, FaceTag::kSide), 2 * (12 + 9) * 8);
}

}  // namespace
}  // namespace citykiln::buildings
