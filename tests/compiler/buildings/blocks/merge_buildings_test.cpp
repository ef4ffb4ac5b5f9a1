#include "compiler/buildings/blocks/merge_buildings.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/compiler/buildings/blocks/made_town.h"

namespace citykiln::buildings {
namespace {

std::vector<Block> merged(std::span<const Building> buildings, double tolerance_m) {
  return merge_buildings(buildings, std::vector(buildings.size(), BlockRole::kMerged), tolerance_m);
}

double plan_area_m2(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += twice_area(in_plan(mesh.positions[a]), in_plan(mesh.positions[b]), in_plan(mesh.positions[c])) / 2;
  return area;
}

TEST(MergeBuildings, MakesOneBlockOfARowOfHouses) {
  const std::vector row = {box_building(1, {0, 0}, 10, 12, 9), box_building(2, {10, 0}, 10, 12, 10),
                           box_building(3, {20, 0}, 10, 12, 11)};
  const std::vector<Block> blocks = merged(row, 25);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0].members, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_NEAR(plan_area_m2(blocks[0].roof), 30 * 12, 1e-9);
  for (const Vec3 p : blocks[0].roof.positions) EXPECT_EQ(p.z, 10);
  // a box without its underside
  EXPECT_EQ(blocks[0].roof.triangles.size() + blocks[0].walls.triangles.size(), 10u);
}

TEST(MergeBuildings, ClosesNarrowGapsOnly) {
  const auto pair = [](double gap_m) {
    return std::vector{box_building(1, {0, 0}, 30, 30, 12), box_building(2, {30 + gap_m, 0}, 30, 30, 12)};
  };
  const std::vector<Block> narrow = merged(pair(8), 25), wide = merged(pair(14), 25);
  ASSERT_EQ(narrow.size(), 1u);
  EXPECT_NEAR(plan_area_m2(narrow[0].roof), 68 * 30, 1e-9);
  EXPECT_EQ(wide.size(), 2u);
}

TEST(MergeBuildings, KeepsTowersApart) {
  const std::vector block = {box_building(1, {0, 0}, 40, 40, 15), box_building(2, {40, 0}, 20, 20, 80)};
  const std::vector<Block> blocks = merged(block, 25);
  ASSERT_EQ(blocks.size(), 2u);
  for (const Vec3 p : blocks[1].roof.positions) EXPECT_EQ(p.z, 80);
}

TEST(MergeBuildings, LeavesOutSmallBlocksButNoneThatStandsAlone) {
  const std::vector hut = {box_building(1, {0, 0}, 4, 4, 3)};
  EXPECT_TRUE(merged(hut, 25)[0].roof.triangles.empty());
  const std::vector<Block> alone = merge_buildings(hut, std::vector{BlockRole::kAlone}, 25);
  EXPECT_FALSE(alone[0].roof.triangles.empty());
}

TEST(MergeBuildings, FollowsSlopes) {
  std::vector<Building> street;
  for (int i = 0; i < 6; ++i) street.push_back(box_building(i + 1, {i * 12.0, 0}, 12, 12, 9, i * 4));
  const std::vector<Block> blocks = merged(street, 25);
  ASSERT_EQ(blocks.size(), 1u);
  const auto [low, high] = std::ranges::minmax(blocks[0].roof.positions, {}, &Vec3::z);
  EXPECT_NEAR(low.z, 9, 0.01);
  EXPECT_NEAR(high.z, 29, 0.01);
}

// Every roof's outline has a wall below it, or a higher block's wall beside it: upward faces of a column-wise closed
// surface cover what its walls span.
TEST(MergeBuildings, ClosesEveryOutlineByWalls) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Building> town = random_town(seed, 40, 0);
    std::map<std::array<Vec3, 2>, int> edges;
    for (const Block& block : merged(town, 25))
      for (const Mesh* mesh : {&block.roof, &block.walls})
        for (const Triangle& t : mesh->triangles)
          for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = mesh->positions[t[i]], b = mesh->positions[t[(i + 1) % 3]];
            ++edges[{a, b}], --edges[{b, a}];
          }
    // along edges that are not vertical, what is open is a foot: nothing lies below it in the surface
    int feet = 0;
    for (const auto& [edge, count] : edges) {
      if (count <= 0 || in_plan(edge[0]) == in_plan(edge[1])) continue;
      EXPECT_EQ(count, 1);
      ++feet;
      for (const auto& [other, times] : edges) {
        const bool is_same_line = in_plan(other[0]) == in_plan(edge[0]) && in_plan(other[1]) == in_plan(edge[1]);
        if (is_same_line && times != 0) {
          EXPECT_GE(std::max(other[0].z, other[1].z), std::min(edge[0].z, edge[1].z));
        }
      }
    }
    EXPECT_GT(feet, 20);
  }
}

TEST(MergeBuildings, TakesNoBuildings) { EXPECT_TRUE(merged({}, 25).empty()); }

}  // namespace
}  // namespace citykiln::buildings
