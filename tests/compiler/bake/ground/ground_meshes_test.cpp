#include "compiler/bake/ground/ground_meshes.h"

#include <gtest/gtest.h>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/materials/texture.h"

namespace citykiln::bake {
namespace {

using map::LaneDirection;
using map::LaneKind;

// Two lanes, one each way, of a main road: marked by a line between them.
roads::MarkingLayout marked() {
  roads::MarkingLayout layout;
  layout.surface = map::LandCoverClass::kPrimaryRoad;
  layout.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 3}, {LaneKind::kDriving, LaneDirection::kForward, 4}};
  return layout;
}

// A piece 10 m long and 7 m wide along x, as two triangles of the ground.
struct OnePiece {
  scene::LandCover cover;
  ground::GroundMesh ground;

  explicit OnePiece(std::uint32_t layout) {
    roads::Piece piece;
    piece.surface = map::LandCoverClass::kPrimaryRoad;
    piece.frame = {{0, 0}, {1, 0}, 7, 0, {3, -4, 0, 0, 100}, {3, -4, 10, 10, 110}};
    piece.layout = layout;
    cover.layouts = {marked()};
    cover.pieces = {piece};
    cover.surfaces = {{{{OsmType::kWay, 9}, 0}, piece.surface, 1, {{{0, -4}, {10, -4}, {10, 3}, {0, 3}}}, 1}};
    ground.mesh.positions = {{0, -4, 0}, {10, -4, 0}, {10, 3, 0}, {0, 3, 0}};
    ground.mesh.normals.assign(4, {0, 0, 1});
    ground.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    ground.face_cover = {0, 0};
    ground.first_vertical = 2;
  }
};

TEST(Markings, OfAStripDrawnEitherWayShareAColumn) {
  scene::LandCover cover;
  cover.layouts = {marked(), roads::turned_round(marked())};
  const Markings markings = lay_out_markings(cover.layouts, 0.05);
  ASSERT_EQ(markings.columns.size(), 2u);
  EXPECT_EQ(markings.columns[0].left_m, markings.columns[1].left_m);
  EXPECT_NE(markings.columns[0].is_turned, markings.columns[1].is_turned);
  EXPECT_EQ(markings.columns[0].width_m, 7);
}

std::vector<materials::MaterialMesh> without_layers(std::vector<LayeredMesh> layered) {
  std::vector<materials::MaterialMesh> meshes;
  for (LayeredMesh& each : layered) meshes.push_back(std::move(each.mesh));
  return meshes;
}

TEST(GroundMeshes, PutsMarkedPiecesOnTheMarkingAtlas) {
  const OnePiece one(0);
  const Markings markings = lay_out_markings(one.cover.layouts, 0.05);
  const auto meshes = without_layers(material_meshes(one.ground, one.cover, markings, {}, 0.05));
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].colour_source, materials::ColourSource::kByMarkingAtlas);
  EXPECT_EQ(meshes[0].feature.id, 9);
  // four corners, one vertex each, across the pattern's column and along the road
  ASSERT_EQ(meshes[0].uvs.size(), 4u);
  const Column& column = markings.columns[0];
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 p = meshes[0].mesh.positions[i];
    Vec2 uv{3 - p.y, 100 + p.x};
    if (column.is_turned) uv = {7 - uv.x, column.length_m - uv.y};
    EXPECT_NEAR(distance(meshes[0].uvs[i], uv + Vec2{column.left_m, 0}), 0, 1e-9);
  }
}

TEST(GroundMeshes, TellsTheMetresOfPiecesThatAreNotMarkedLessWholePeriods) {
  const OnePiece one(roads::kNoMarkingLayout);
  const auto meshes =
      without_layers(material_meshes(one.ground, one.cover, lay_out_markings(one.cover.layouts, 0.05), {}, 0.05));
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].colour_source, materials::ColourSource::kByMaterial);
  EXPECT_EQ(meshes[0].uvs[0], (Vec2{7, 100 - materials::kTexturePeriod_m}));
}

// The meshes of an unmarked residential street this wide.
std::vector<materials::MaterialMesh> street(double width_m, double tolerance_m, double left_u_m = 0) {
  OnePiece one(roads::kNoMarkingLayout);
  one.cover.pieces[0].surface = one.cover.surfaces[0].surface = map::LandCoverClass::kResidentialRoad;
  roads::PieceFrame& frame = one.cover.pieces[0].frame;
  frame.width_m = width_m, frame.left_u_m = left_u_m, frame.start.right_m = frame.end.right_m = 3 - width_m;
  for (Vec3& p : one.ground.mesh.positions) p.y = p.y < 0 ? 3 - width_m : 3;
  return without_layers(
      material_meshes(one.ground, one.cover, lay_out_markings(one.cover.layouts, 0.05), {}, tolerance_m));
}

TEST(GroundMeshes, UnmarkedStreetsShowTheLanesOfTheirTextureFromEdgeToEdge) {
  using materials::Material;
  const double side_m = materials::texture_side_m(Material::kStreetAsphalt);
  for (const auto& [width_m, shown_m] : {std::pair{5.5, side_m}, std::pair{9.0, side_m}, std::pair{3.0, side_m / 2}}) {
    const auto meshes = street(width_m, 0.1);
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].material, Material::kStreetAsphalt);
    EXPECT_NEAR(meshes[0].uvs[0].x, shown_m, materials::kTextureCoordinateStep_m);
    EXPECT_NEAR(meshes[0].uvs[2].x, 0, materials::kTextureCoordinateStep_m);
    EXPECT_EQ(meshes[0].uvs[1].y - meshes[0].uvs[0].y, 10);
  }
}

TEST(GroundMeshes, SquaresPartsOfStreetsAndCoarseLevelsShowPlainAsphalt) {
  EXPECT_EQ(street(16, 0.1)[0].material, materials::Material::kOldAsphalt);
  EXPECT_EQ(street(5.5, 0.1, 2.75)[0].material, materials::Material::kOldAsphalt);
  EXPECT_EQ(street(5.5, 0.5)[0].material, materials::Material::kOldAsphalt);
}

TEST(GroundMeshes, KnowTheLayerOfTheirClass) {
  EXPECT_EQ(layer_of(map::LandCoverClass::kMeadow), Layer::kGround);
  EXPECT_EQ(layer_of(map::LandCoverClass::kBuilding), Layer::kGround);
  EXPECT_EQ(layer_of(map::LandCoverClass::kKerb), Layer::kRoads);
  EXPECT_EQ(layer_of(map::LandCoverClass::kRailway), Layer::kRoads);
  EXPECT_EQ(layer_of(map::LandCoverClass::kRiver), Layer::kWater);
  const OnePiece one(0);
  for (const LayeredMesh& part :
       material_meshes(one.ground, one.cover, lay_out_markings(one.cover.layouts, 0.05), {}, 0.05))
    EXPECT_EQ(part.layer, layer_of(one.cover.surfaces[0].surface));
}

// Land of one class: a level square, and one that rises from x = 50 on.
struct Slope {
  scene::LandCover cover;
  ground::GroundMesh ground;

  Slope(map::LandCoverClass surface, double rise) {
    cover.surfaces = {{{{OsmType::kWay, 5}, 0}, surface, 1, {{{0, 0}, {90, 0}, {90, 50}, {0, 50}}}}};
    for (const double y : {3.0, 50.0})
      for (const double x : {3.0, 50.0, 90.0}) ground.mesh.positions.push_back({x, y, x > 50 ? rise * (x - 50) : 0});
    for (const Vec3& p : ground.mesh.positions) ground.mesh.normals.push_back(unit(Vec3{p.x >= 50 ? -rise : 0, 0, 1}));
    ground.mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    ground.face_cover = {0, 0, 0, 0};
    ground.first_vertical = 4;
  }

  std::vector<materials::MaterialMesh> dressed(double tolerance_m, std::optional<double> snow_line_m = {},
                                               bool has_wild_slopes = true) const {
    scene::Header header;
    header.snow_line_m = snow_line_m, header.has_wild_slopes = has_wild_slopes;
    return without_layers(material_meshes(ground, cover, {}, header, tolerance_m));
  }
};

TEST(GroundMeshes, SteepFacesAreMeshesOfRockOfTheSameFeature) {
  const auto meshes = Slope(map::LandCoverClass::kMeadow, 3).dressed(0.02);
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].material, materials::Material::kMeadow);
  EXPECT_EQ(meshes[1].material, materials::Material::kRock);
  for (const auto& mesh : meshes) {
    EXPECT_EQ(mesh.mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.feature.id, 5);
  }
  // up the wall, not seen from above
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(meshes[1].uvs[i].y, meshes[1].mesh.positions[i].z);
}

TEST(GroundMeshes, UprightLandIsMasonryAndTellsItsHeight) {
  Slope quay(map::LandCoverClass::kMeadow, 0);
  quay.ground.mesh.positions = {{10, 20, 0}, {14, 20, 0}, {14, 20, 3}};
  quay.ground.mesh.normals.assign(3, {0, -1, 0});
  quay.ground.mesh.triangles = {{0, 1, 2}}, quay.ground.face_cover = {0}, quay.ground.first_vertical = 0;
  const auto meshes = quay.dressed(0.02);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].material, materials::Material::kStone);
  EXPECT_EQ(meshes[0].uvs, (std::vector<Vec2>{{10, 0}, {14, 0}, {14, 3}}));
}

TEST(GroundMeshes, ASliverIsNotSteepWhereTheLandAboutItIsNot) {
  Slope land(map::LandCoverClass::kMeadow, 0);
  land.ground.mesh.positions[1].z = 300;
  EXPECT_FALSE(land.dressed(0.02).empty());
  for (const auto& mesh : land.dressed(0.02)) EXPECT_EQ(mesh.material, materials::Material::kMeadow);
}

TEST(GroundMeshes, SnowIsAskedForByTheHeader) {
  const Slope high(map::LandCoverClass::kMeadow, 0.2);
  EXPECT_EQ(high.dressed(0.02).size(), 1u);
  const auto meshes = high.dressed(0.02, -100);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].material, materials::Material::kSnow);
}

TEST(GroundMeshes, SteepUnmappedLandIsScrubOnAllLevelsWhereThatIsAssumed) {
  const Slope hill(map::LandCoverClass::kUnknown, 0.6);
  for (const double tolerance_m : {0.02, 0.1, 2.5}) {
    const auto wild = hill.dressed(tolerance_m), plain = hill.dressed(tolerance_m, {}, false);
    ASSERT_EQ(wild.size(), 2u);
    EXPECT_EQ(wild[0].material, materials::Material::kUnknownGround);
    EXPECT_EQ(wild[1].material, materials::Material::kScrub);
    ASSERT_EQ(plain.size(), 1u);
    EXPECT_EQ(plain[0].material, materials::Material::kUnknownGround);
  }
}

TEST(GroundMeshes, EachVertexHasATintAndAPlaceWhereThereIsATexture) {
  const Slope slope(map::LandCoverClass::kFarmland, 0.1);
  for (const double tolerance_m : {0.02, 0.1, 0.25, 2.5}) {
    EXPECT_FALSE(slope.dressed(tolerance_m).empty());
    for (const auto& mesh : slope.dressed(tolerance_m)) {
      EXPECT_EQ(mesh.mesh.positions.size(), 6u);
      EXPECT_EQ(mesh.tints.size(), 6u);
      EXPECT_EQ(mesh.uvs.size(), has_detail(Detail::kMaterialTextures, tolerance_m) ? 6u : 0u);
    }
  }
}

TEST(GroundMeshes, LevelsHaveTheSameTints) {
  const Slope slope(map::LandCoverClass::kFarmland, 0.1);
  EXPECT_EQ(slope.dressed(0.02)[0].tints, slope.dressed(12.5)[0].tints);
}

TEST(GroundMeshes, WhatLiesUnderBuildingsHasNoPlaces) {
  const auto meshes = Slope(map::LandCoverClass::kBuilding, 0).dressed(0.02);
  EXPECT_FALSE(meshes.empty());
  for (const auto& mesh : meshes) EXPECT_TRUE(mesh.uvs.empty());
}

}  // namespace
}  // namespace citykiln::bake
