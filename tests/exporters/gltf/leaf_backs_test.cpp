#include "exporters/gltf/leaf_backs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

bake::Primitive made_leaves(std::uint32_t seed) {
  std::mt19937 dice(seed);
  bake::InstancedMesh tree;
  make_leafy(dice, tree, false);
  return tree.primitives.front();
}

Vec3 area_of(const bake::Primitive& p, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = bake::widened(p.positions[t[0]]);
  return cross(bake::widened(p.positions[t[1]]) - a, bake::widened(p.positions[t[2]]) - a);
}

TEST(LeafBacks, FaceTheOtherWayOnTheSameVertices) {
  const bake::Primitive front = made_leaves(1), both = with_backs(front);
  const std::size_t count = front.triangles.size();
  ASSERT_GT(count, 0u);
  ASSERT_EQ(both.triangles.size(), 2 * count);
  EXPECT_EQ(both.positions, front.positions);
  EXPECT_EQ(both.normals, front.normals);
  EXPECT_EQ(both.colours, front.colours);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(area_of(both, both.triangles[count + i]), area_of(front, front.triangles[i]) * -1);
}

TEST(LeafBacks, AreRemoved) {
  const bake::Primitive front = made_leaves(2);
  EXPECT_EQ(without_backs(with_backs(front)), front);
  EXPECT_EQ(without_backs(front), front);
}

// Codecs put triangles into another order, begin them at another corner, and may divide vertices.
TEST(LeafBacks, AreRemovedWhateverTheOrderOfVerticesAndTriangles) {
  const bake::Primitive front = made_leaves(3);
  bake::Primitive mixed = with_backs(front);
  std::ranges::reverse(mixed.triangles);
  for (auto& t : mixed.triangles) std::ranges::rotate(t, t.begin() + 1);
  const auto count = static_cast<std::uint32_t>(mixed.positions.size());
  for (auto* values : {&mixed.positions, &mixed.normals}) values->insert(values->end(), values->begin(), values->end());
  mixed.uvs.insert(mixed.uvs.end(), mixed.uvs.begin(), mixed.uvs.end());
  mixed.colours.insert(mixed.colours.end(), mixed.colours.begin(), mixed.colours.end());
  for (std::uint32_t& v : mixed.triangles.front()) v += count;
  EXPECT_EQ(without_backs(mixed).triangles.size(), front.triangles.size());
}

TEST(LeafBacks, OnlyLeavesHaveThem) {
  EXPECT_TRUE(has_backs(made_leaves(3)));
  for (const bake::Primitive& p : made_facade_tile(1).primitives) EXPECT_FALSE(has_backs(p));
}

}  // namespace
}  // namespace citykiln::exporters
