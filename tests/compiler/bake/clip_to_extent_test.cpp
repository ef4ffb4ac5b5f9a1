#include "compiler/bake/clip_to_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <map>

namespace citykiln::bake {
namespace {

using materials::MaterialMesh;

constexpr Box2 kExtent{{0, 0}, {128, 128}};

// A closed box, turned so that no side of it is parallel to the extent's.
MaterialMesh turned_box(Vec2 middle, double half_m, double low_m, double high_m) {
  MaterialMesh box;
  for (const double z : {low_m, high_m})
    for (const Vec2 corner : {Vec2{0.75, 0.5}, Vec2{-0.5, 0.75}, Vec2{-0.75, -0.5}, Vec2{0.5, -0.75}})
      box.mesh.positions.push_back(at_height(middle + corner * half_m, z));
  add_quad(box.mesh, 3, 2, 1, 0);
  add_quad(box.mesh, 4, 5, 6, 7);
  for (std::uint32_t i = 0; i < 4; ++i) add_quad(box.mesh, i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i);
  return box;
}

double volume_m3(std::initializer_list<const Mesh*> meshes) {
  double volume = 0;
  for (const Mesh* mesh : meshes)
    for (const Triangle& t : mesh->triangles)
      volume += dot(mesh->positions[t[0]], cross(mesh->positions[t[1]], mesh->positions[t[2]])) / 6;
  return volume;
}

// Every edge has a face on either side.
bool is_closed(std::initializer_list<const Mesh*> meshes) {
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const Mesh* mesh : meshes)
    for (const Triangle& t : mesh->triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = mesh->positions[t[i]], b = mesh->positions[t[(i + 1) % 3]];
        a < b ? ++edges[{a, b}] : --edges[{b, a}];
      }
  return !edges.empty() && std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

Mesh clip_solid(MaterialMesh& mesh) {
  MaterialMesh* const meshes[] = {&mesh};
  return clip_solid_to_extent(meshes, kExtent);
}

TEST(ClipToExtent, AMeshInsideStaysUnchanged) {
  MaterialMesh box = turned_box({64, 64}, 16, 1, 5);
  const MaterialMesh before = box;
  EXPECT_TRUE(clip_solid(box).triangles.empty());
  EXPECT_EQ(box.mesh.positions, before.mesh.positions);
  EXPECT_EQ(box.mesh.triangles, before.mesh.triangles);
}

TEST(ClipToExtent, AMeshOutsideBecomesEmpty) {
  MaterialMesh box = turned_box({200, 64}, 16, 1, 5);
  EXPECT_TRUE(clip_solid(box).triangles.empty());
  EXPECT_TRUE(box.mesh.triangles.empty());
  EXPECT_TRUE(box.mesh.positions.empty());
}

TEST(ClipToExtent, ASolidStaysClosedAndKeepsTheVolumeInside) {
  // at a side; and at a corner, where a quarter is left
  for (const auto& [middle, share] : {std::pair(Vec2{128, 64}, 0.5),
                                      {Vec2{64, 0}, 0.5},
                                      {Vec2{0, 0}, 0.25},
                                      {Vec2{0, 128}, 0.25},
                                      {Vec2{128, 128}, 0.25}}) {
    MaterialMesh box = turned_box(middle, 16, 1, 5);
    const double whole_m3 = volume_m3({&box.mesh});
    const Mesh caps = clip_solid(box);
    EXPECT_TRUE(is_closed({&box.mesh, &caps})) << middle.x << " " << middle.y;
    EXPECT_NEAR(volume_m3({&box.mesh, &caps}), whole_m3 * share, whole_m3 * 1e-3) << middle.x << " " << middle.y;
    for (const Mesh* mesh : std::initializer_list<const Mesh*>{&box.mesh, &caps})
      for (const Vec3 p : mesh->positions) EXPECT_TRUE(kExtent.contains(in_plan(p)));
  }
}

TEST(ClipToExtent, SeveralMeshesOfOneBodyAreClosedTogether) {
  MaterialMesh sides = turned_box({128, 64}, 16, 1, 5), top;
  top.mesh.positions = sides.mesh.positions;
  top.mesh.triangles = {sides.mesh.triangles[2], sides.mesh.triangles[3]};
  sides.mesh.triangles.erase(sides.mesh.triangles.begin() + 2, sides.mesh.triangles.begin() + 4);
  MaterialMesh* const meshes[] = {&sides, &top};
  const Mesh caps = clip_solid_to_extent(meshes, kExtent);
  EXPECT_TRUE(is_closed({&sides.mesh, &top.mesh, &caps}));
}

TEST(ClipToExtent, AHollowBodyStaysOpen) {
  MaterialMesh box = turned_box({128, 64}, 16, 1, 5);
  MaterialMesh* const meshes[] = {&box};
  clip_to_extent(meshes, kExtent);
  EXPECT_FALSE(box.mesh.triangles.empty());
  EXPECT_FALSE(is_closed({&box.mesh}));
}

TEST(ClipToExtent, AttributesAreInterpolated) {
  MaterialMesh mesh;
  mesh.mesh.positions = {{120, 10, 0}, {136, 10, 8}, {120, 20, 0}};
  mesh.mesh.normals.assign(3, {0, 0, 1});
  mesh.mesh.triangles = {{0, 1, 2}};
  mesh.uvs = {{0, 0}, {16, 2}, {0, 10}};
  mesh.tints = {{0, 0, 0, 255}, {200, 100, 50, 255}, {0, 0, 0, 255}};
  MaterialMesh* const meshes[] = {&mesh};
  clip_to_extent(meshes, kExtent);
  const auto cut = std::ranges::find(mesh.mesh.positions, Vec3{128, 10, 4});
  ASSERT_NE(cut, mesh.mesh.positions.end());
  const auto i = static_cast<std::size_t>(cut - mesh.mesh.positions.begin());
  EXPECT_EQ(mesh.uvs[i], (Vec2{8, 1}));
  EXPECT_EQ(mesh.tints[i], (materials::Tint{100, 50, 25, 255}));
  EXPECT_EQ(mesh.mesh.normals[i], (Vec3{0, 0, 1}));
  EXPECT_EQ(mesh.mesh.positions.size(), mesh.uvs.size());
}

}  // namespace
}  // namespace citykiln::bake
