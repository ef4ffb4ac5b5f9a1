#include "compiler/structures/expand.h"

#include <gtest/gtest.h>

#include <map>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

Span bent() {
  return {{{OsmType::kWay, 5}, 0},
          {{0, 0, 10}, {20, 0, 12}, {30, 10, 12}, {30, 40, 9}},
          map::SurfaceClass::kPrimaryRoad,
          8};
}

// How often each edge is walked from the one position to the other, less how often back.
std::map<std::pair<Vec3, Vec3>, int> open_edges(const std::vector<materials::DressedMesh>& meshes) {
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const auto& dressed : meshes)
    for (const Triangle& t : dressed.mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = dressed.mesh.positions[t[i]], b = dressed.mesh.positions[t[(i + 1) % 3]];
        if (a < b)
          ++edges[{a, b}];
        else
          --edges[{b, a}];
      }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

double volume_m3(const std::vector<materials::DressedMesh>& meshes) {
  double six = 0;
  for (const auto& dressed : meshes)
    for (const auto& [a, b, c] : dressed.mesh.triangles) {
      const auto& p = dressed.mesh.positions;
      six += dot(p[a], cross(p[b], p[c]));
    }
  return six / 6;
}

TEST(Expand, ClosesTheSlab) { EXPECT_TRUE(open_edges(expand(bent(), 0.02).meshes).empty()); }

TEST(Expand, HasTheSlabsVolumeOutward) {
  Span straight = bent();
  straight.axis = {{0, 0, 10}, {50, 0, 10}};
  EXPECT_NEAR(volume_m3(expand(straight, 0.02).meshes), 50 * 8 * 0.8, 0.4);
  EXPECT_GT(volume_m3(expand(bent(), 0.02).meshes), 0);
}

TEST(Expand, PutsTheRoadOnTop) {
  const Expanded e = expand(bent(), 0.02);
  EXPECT_EQ(e.meshes[0].material, materials::Material::kAsphalt);
  EXPECT_EQ(e.meshes[1].material, materials::Material::kConcrete);
  EXPECT_EQ(e.meshes[0].feature, bent().id.osm);
}

TEST(Expand, MitresBendsToTheFullWidth) {
  const Expanded e = expand(bent(), 0.02);
  // left and right of the second axis point lie on lines 4 m from both segments
  const Vec3 left = e.meshes[0].mesh.positions[2], right = e.meshes[0].mesh.positions[3];
  EXPECT_NEAR(left.y, 4, 0.001);
  EXPECT_NEAR(right.y, -4, 0.001);
  const Vec2 along = unit(Vec2{1, 1});
  EXPECT_NEAR(cross(along, Vec2{left.x - 20, left.y}), 4, 0.002);
}

TEST(Expand, LeavesTheDeckAloneAboveTheSlabsThickness) {
  const Expanded e = expand(bent(), 2.5);
  EXPECT_EQ(e.meshes.size(), 1u);
  EXPECT_NEAR(e.error_m, 0.8, 1e-12);
  EXPECT_EQ(expand(bent(), 0.5).error_m, 0);
}

TEST(Expand, IsTotalOnHairpinsAndStubs) {
  Span span = bent();
  span.axis = {{0, 0, 0}, {10, 0, 0}, {0, 0, 0}};
  for (const auto& dressed : expand(span, 0.02).meshes)
    for (const Vec3 p : dressed.mesh.positions) EXPECT_EQ(p, snapped(p));
  span.axis = {{0, 0, 0}};
  EXPECT_TRUE(expand(span, 0.02).meshes.empty());
}

}  // namespace
}  // namespace citykiln::structures
