#include "compiler/scene/yard_recipes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/lots/draw_yard.h"

namespace citykiln::scene {
namespace {

constexpr std::uint64_t kSeed = 4;

// Yards side by side, of which all plants stand.
Chunk made_chunk() {
  StrippedChunk stripped;
  for (int i = 0; i < 12; ++i) {
    const double x = 20.0 * i;
    lots::Yard yard{.building = {{OsmType::kWay, 1000 - 7 * i}, 0},
                    .country = map::CountryGroup::kBritishIsles,
                    .kind = lots::LotKind::kDetached,
                    .polygon = {{{x, 0}, {x + 20, 0}, {x + 20, 40}, {x, 40}}, {}},
                    .frame = {{x + 10, 0}, lots::kHeadings / 4},
                    .setback_m = 8};
    yard.strips = {{false, {2, 8.25}, {2, -0.25}}};
    yard.borders = {{40, 60, lots::BorderPlace::kElsewhere}};
    yard.plants.assign(lots::plants_drawn(yard, *lots::rule_of(yard, kSeed), kSeed).size(), true);
    stripped.chunk.yards.push_back(yard);
  }
  return restore_yards(std::move(stripped), kSeed);
}

TEST(YardRecipes, StripsAllThatYardsGenerate) {
  const Chunk chunk = made_chunk();
  EXPECT_GE(chunk.surfaces.size(), 24u);
  EXPECT_EQ(chunk.barriers.size(), 12u);
  EXPECT_GT(chunk.trees.size(), 12u);
  const StrippedChunk made = strip_yards(chunk, kSeed);
  EXPECT_TRUE(made.chunk.surfaces.empty() && made.chunk.barriers.empty() && made.chunk.trees.empty());
  EXPECT_EQ(restore_yards(StrippedChunk(made), kSeed), chunk);
}

TEST(YardRecipes, KeepsWhatYardsDoNotGenerate) {
  Chunk chunk = made_chunk();
  chunk.surfaces[3].rings[0].pop_back();
  chunk.trees[2].height_m = 77;
  chunk.barriers[1].height_m += 1;
  const std::size_t trees = chunk.trees.size();
  chunk.trees.insert(chunk.trees.begin(), {{{OsmType::kNode, 1}, 0}, {3, 3}, 9, {}});
  chunk.trees.erase(chunk.trees.begin() + 6);
  chunk.surfaces.erase(chunk.surfaces.begin() + 7);
  const StrippedChunk made = strip_yards(chunk, kSeed);
  EXPECT_EQ(made.chunk.surfaces.size(), 1u);
  EXPECT_EQ(made.chunk.barriers.size(), 1u);
  EXPECT_EQ(made.chunk.trees.size(), 2u);
  std::size_t suppressed = 0;
  for (const std::vector<bool>& each : made.suppressed)
    suppressed += static_cast<std::size_t>(std::ranges::count(each, true));
  EXPECT_EQ(suppressed, 5u);
  EXPECT_EQ(restore_yards(StrippedChunk(made), kSeed), chunk);
  EXPECT_EQ(chunk.trees.size(), trees);
}

TEST(YardRecipes, ListsThatAreNotSortedStayAsTheyAre) {
  Chunk chunk = made_chunk();
  std::ranges::reverse(chunk.trees);
  EXPECT_EQ(restore_yards(strip_yards(chunk, kSeed), kSeed), chunk);
}

TEST(YardRecipes, TwoYardsOfOneBuildingLoseNothing) {
  Chunk chunk = made_chunk();
  chunk.yards.push_back(chunk.yards.front());
  EXPECT_EQ(restore_yards(strip_yards(chunk, kSeed), kSeed), chunk);
}

TEST(YardRecipes, AnotherSeedLosesNothing) {
  const Chunk chunk = made_chunk();
  EXPECT_EQ(restore_yards(strip_yards(chunk, kSeed + 1), kSeed + 1), chunk);
}

}  // namespace
}  // namespace citykiln::scene
