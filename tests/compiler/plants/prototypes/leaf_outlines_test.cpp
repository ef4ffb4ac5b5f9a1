#include "compiler/plants/prototypes/leaf_outlines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::plants {
namespace {

// A leaf of 40 corners, 2 m long and 1 m wide, upright.
std::vector<Vec3> oval() {
  std::vector<Vec3> ring;
  for (int i = 0; i < 40; ++i) {
    const double turn = 2 * M_PI * i / 40;
    ring.push_back({0.5 * std::cos(turn), 0, 1 + std::sin(turn)});
  }
  return ring;
}

double area_m2(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += length(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]])) / 2;
  return sum;
}

TEST(LeafOutlines, AreTriangulatedWithTheirArea) {
  const Mesh mesh = outline_mesh(oval(), {0, -1, 0});
  EXPECT_EQ(mesh.triangles.size(), 38u);
  EXPECT_NEAR(area_m2(mesh), M_PI * 0.5, 0.02);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    EXPECT_LT(cross(b - a, c - a).y, 0) << "its front is in front";
  }
}

TEST(LeafOutlines, AreSimplifiedAndKeepTheirSides) {
  EXPECT_EQ(simplified_outline(oval(), 0).size(), 40u);
  const std::vector<Vec3> coarse = simplified_outline(oval(), 0.1);
  EXPECT_LT(coarse.size(), 13u);
  EXPECT_GE(coarse.size(), 4u);
  EXPECT_NEAR(area_m2(outline_mesh(coarse, {0, -1, 0})), M_PI * 0.5, 0.35);
  EXPECT_EQ(simplified_outline(oval(), 10).size(), 3u);
}

}  // namespace
}  // namespace citykiln::plants
