#include "compiler/bake/dress_ground.h"

#include <gtest/gtest.h>

namespace citykiln::bake {
namespace {

using map::Lane;
using map::LaneKind;
using map::LaneWay;

// Two lanes, one each way, of a main road: marked by a line between them.
roads::Pattern marked() {
  roads::Pattern pattern;
  pattern.surface = map::SurfaceClass::kPrimaryRoad;
  pattern.lanes = {{LaneKind::kDriving, LaneWay::kBackward, 3}, {LaneKind::kDriving, LaneWay::kForward, 4}};
  return pattern;
}

// A piece 10 m long and 7 m wide along x, as two triangles of the ground.
struct OnePiece {
  scene::GroundCover cover;
  ground::GroundMesh ground;

  explicit OnePiece(std::uint32_t pattern) {
    roads::Piece piece;
    piece.surface = map::SurfaceClass::kPrimaryRoad;
    piece.frame = {{0, 0}, {1, 0}, 7, {3, -4, 0, 0, 100}, {3, -4, 10, 10, 110}};
    piece.pattern = pattern;
    cover.patterns = {marked()};
    cover.pieces = {piece};
    cover.surfaces = {{{{OsmType::kWay, 9}, 0}, piece.surface, 1, {{{0, -4}, {10, -4}, {10, 3}, {0, 3}}}, 1}};
    ground.mesh.positions = {{0, -4, 0}, {10, -4, 0}, {10, 3, 0}, {0, 3, 0}};
    ground.mesh.normals.assign(4, {0, 0, 1});
    ground.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    ground.face_surface = {0, 0};
  }
};

TEST(Markings, OfAStripDrawnEitherWayShareAColumn) {
  scene::GroundCover cover;
  cover.patterns = {marked(), roads::turned_round(marked())};
  const Markings markings = lay_out_markings(cover, 0.05);
  ASSERT_EQ(markings.columns.size(), 2u);
  EXPECT_EQ(markings.columns[0].left_m, markings.columns[1].left_m);
  EXPECT_NE(markings.columns[0].is_turned, markings.columns[1].is_turned);
  EXPECT_EQ(markings.columns[0].width_m, 7);
}

TEST(DressGround, PutsMarkedPiecesOnTheSheet) {
  const OnePiece one(0);
  const Markings markings = lay_out_markings(one.cover, 0.05);
  const auto meshes = dress(one.ground, one.cover, markings, 1);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_TRUE(meshes[0].is_on_sheet);
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

TEST(DressGround, KeepsTheMetresOfPiecesThatAreNotMarked) {
  const OnePiece one(roads::kNoPattern);
  const auto meshes = dress(one.ground, one.cover, lay_out_markings(one.cover, 0.05), 1);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_FALSE(meshes[0].is_on_sheet);
  EXPECT_EQ(meshes[0].uvs[0], (Vec2{7, 100}));
}

}  // namespace
}  // namespace citykiln::bake
