#include "compiler/ground/mesh/reference_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/ground/mesh/made_references.h"

namespace citykiln::ground {
namespace {

using Edges = std::vector<std::pair<GridPoint, GridPoint>>;

constexpr Box2 kCellOfEdges{{0, 0}, {128, 128}};

GridPoint at(double x, double y) { return grid_point({x, y}); }

// Four triangles about (64, 64), and a fifth vertex at (128, 64) on the border.
Reference star() {
  const std::vector<GridPoint> vertices = {at(0, 0), at(0, 128), at(64, 64), at(128, 0), at(128, 64), at(128, 128)};
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> edges = {{0, 1}, {0, 3}, {1, 5}, {3, 4}, {4, 5},
                                                                      {0, 2}, {1, 2}, {2, 3}, {2, 4}, {2, 5}};
  return reference_of(Delaunay(vertices, edges), std::vector<Heights>(vertices.size()), kCellOfEdges);
}

Edges edges_in(const Reference& reference, std::array<GridPoint, 3> triangle, const std::vector<GridPoint>& kept) {
  return edges_about(reference, std::span(&triangle, 1), kept);
}

const std::vector<GridPoint> kCorners = {at(0, 0), at(0, 128), at(128, 0), at(128, 128)};

TEST(ReferenceEdges, AreThoseOfFacesThatOverlap) {
  EXPECT_EQ(edges_in(star(), {at(10, 50), at(20, 50), at(10, 60)}, kCorners),
            (Edges{{at(0, 0), at(64, 64)}, {at(0, 128), at(64, 64)}}));
}

TEST(ReferenceEdges, OfFacesThatOnlyTouchAreLeftOut) {
  EXPECT_EQ(edges_in(star(), {at(0, 0), at(64, 64), at(0, 128)}, kCorners).size(), 2u);
}

TEST(ReferenceEdges, AddNoVertexToTheCellsBorder) {
  const std::array<GridPoint, 3> beside = {at(100, 50), at(110, 60), at(100, 60)};
  EXPECT_EQ(edges_in(star(), beside, kCorners),
            (Edges{{at(64, 64), at(128 - kFromBorder_m, 64)}, {at(64, 64), at(128, 0)}}));
  std::vector<GridPoint> kept = kCorners;
  kept.insert(kept.begin() + 3, at(128, 64));
  EXPECT_EQ(edges_in(star(), beside, kept), (Edges{{at(64, 64), at(128, 0)}, {at(64, 64), at(128, 64)}}));
}

TEST(ReferenceEdges, OfTheTerrainAreNone) {
  const map::Heightfield flat{{-64, -64}, {64, 64}, 5, 5, std::vector<std::int32_t>(25, 640), 0};
  EXPECT_TRUE(edges_in(reference_of(flat, kCellOfEdges), {at(0, 0), at(64, 0), at(64, 64)}, kCorners).empty());
}

}  // namespace
}  // namespace citykiln::ground
