#include "compiler/buildings/meshes/join_rectangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "compiler/contract/random_sequence.h"

namespace citykiln::buildings {
namespace {

// A rectangle on a wall that stands obliquely: `along` metres along its foot, `up` metres up.
DerivedFace wall_piece(double along, double up, double wide, double high, double detail_distance_m = 0) {
  const Vec3 x = unit(Vec3{3, 1, 0}), z{0, 0, 1}, at = Vec3{1234.5, -98.25, 40} + x * along + z * up;
  DerivedFace piece;
  piece.face.outer = {at, at + x * wide, at + x * wide + z * high, at + z * high};
  piece.detail_distance_m = detail_distance_m;
  return piece;
}

double sum_m2(const std::vector<DerivedFace>& faces) {
  double sum = 0;
  for (const DerivedFace& derived : faces) sum += area_m2(derived.face);
  return sum;
}

// Piers, sills and lintels around windows of which one is 1 m by 1.5 m in each cell of 3 m by 3 m.
std::vector<DerivedFace> wall_with_windows(int columns, int floors) {
  std::vector<DerivedFace> pieces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < floors; ++j) {
      const double x = 3 * i, z = 3 * j;
      pieces.push_back(wall_piece(x, z, 1, 3));
      pieces.push_back(wall_piece(x + 2, z, 1, 3));
      pieces.push_back(wall_piece(x + 1, z, 1, 0.9));
      pieces.push_back(wall_piece(x + 1, z + 2.4, 1, 0.6));
    }
  }
  return pieces;
}

// The corners of all faces in an order of their own.
std::vector<std::array<double, 12>> corners_of(const std::vector<DerivedFace>& faces) {
  std::vector<std::array<double, 12>> all;
  for (const DerivedFace& derived : faces) {
    std::array<double, 12>& corners = all.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = derived.face.outer[i];
      corners[3 * i] = p.x, corners[3 * i + 1] = p.y, corners[3 * i + 2] = p.z;
    }
  }
  std::ranges::sort(all);
  return all;
}

TEST(JoinRectangles, JoinsPiersAcrossFloorsAndWallsBetweenWindows) {
  const std::vector<DerivedFace> pieces = wall_with_windows(4, 5), joined = join_rectangles(pieces);
  // 5 piers, and in each column the walls under, between and over 5 windows
  EXPECT_EQ(joined.size(), 5u + 4 * 6);
  EXPECT_NEAR(sum_m2(joined), sum_m2(pieces), 1e-9);
}

TEST(JoinRectangles, GiveTheUnionWhenAllSidesMeet) {
  std::vector<DerivedFace> pieces;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 3; ++j) pieces.push_back(wall_piece(0.7 * i, 1.1 * j, 0.7, 1.1));
  const std::vector<DerivedFace> joined = join_rectangles(pieces);
  ASSERT_EQ(joined.size(), 1u);
  const DerivedFace whole = wall_piece(0, 0, 7 * 0.7, 3 * 1.1);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(length(joined[0].face.outer[i] - whole.face.outer[i]), 1e-12);
}

TEST(JoinRectangles, DoNotDependOnTheOrder) {
  std::vector<DerivedFace> pieces = wall_with_windows(3, 4);
  const auto expected = corners_of(join_rectangles(pieces));
  const RandomSequence draws(1, StableId{5}, "order");
  for (std::uint32_t turn = 0; turn < 5; ++turn) {
    for (std::size_t i = pieces.size() - 1; i > 0; --i)
      std::swap(pieces[i], pieces[draws.below(static_cast<std::uint32_t>(i + 1), turn * 1000 + i)]);
    EXPECT_EQ(corners_of(join_rectangles(pieces)), expected);
  }
}

TEST(JoinRectangles, KeepTheGreatestDistanceOfDetail) {
  const auto joined = join_rectangles({wall_piece(0, 0, 1, 3, 0.2), wall_piece(1, 0, 1, 3, 0.4)});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].detail_distance_m, 0.4);
}

TEST(JoinRectangles, StayApartUnlessTheyShareAWholeSide) {
  EXPECT_EQ(join_rectangles({wall_piece(0, 0, 1, 3), wall_piece(1, 0, 1, 2.5)}).size(), 2u);
  EXPECT_EQ(join_rectangles({wall_piece(0, 0, 1, 3), wall_piece(1.01, 0, 1, 3)}).size(), 2u);
}

TEST(JoinRectangles, StayApartAtACorner) {
  std::vector<DerivedFace> pieces = {wall_piece(0, 0, 1, 3), wall_piece(1, 0, 1, 3)};
  // the second turns by a sixtieth of a degree
  for (const std::size_t i : {1u, 2u})
    pieces[1].face.outer[i] = pieces[1].face.outer[i] + Vec3{-1, 3, 0} * 3e-4 * 0.316;
  EXPECT_EQ(join_rectangles(pieces).size(), 2u);
}

TEST(JoinRectangles, JoinLevelFacesAndThoseWithOtherFirstCorners) {
  std::vector<DerivedFace> pieces(2);
  pieces[0].face.outer = {{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {0, 1, 5}};
  pieces[1].face.outer = {{2, 2, 5}, {0, 2, 5}, {0, 1, 5}, {2, 1, 5}};
  const auto joined = join_rectangles(pieces);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(area_m2(joined[0].face), 4);
  EXPECT_GT(normal_of(joined[0].face).z, 0.99);
}

TEST(JoinRectangles, KeepOtherFacesAsTheyAre) {
  DerivedFace triangle;
  triangle.face.outer = {{0, 0, 5}, {2, 0, 5}, {2, 1, 5}};
  const auto kept = join_rectangles({triangle, wall_piece(0, 0, 1, 1)});
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].face, triangle.face);
  EXPECT_EQ(kept[1].face, wall_piece(0, 0, 1, 1).face);
}

}  // namespace
}  // namespace citykiln::buildings
