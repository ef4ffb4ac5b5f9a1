#include "compiler/commands/plan/expected_cost.h"

#include <gtest/gtest.h>

#include <vector>

namespace citykiln::commands {
namespace {

PlannedRegion region_of(std::uint64_t way_nodes, std::uint64_t building_nodes) {
  return {.key = {},
          .tiles = 1,
          .file = {.way_nodes = way_nodes, .own_way_nodes = way_nodes, .own_building_nodes = building_nodes},
          .terrain_vertices = 1000,
          .expected = {}};
}

TEST(ExpectedCost, GrowsWithTheDataAndWithEachLevel) {
  const std::vector<double> one{0.1}, two{0.1, 2.5};
  const ExpectedCost small = expected_cost(region_of(1000, 500), 1024, one),
                     large = expected_cost(region_of(9000, 500), 1024, one),
                     levels = expected_cost(region_of(1000, 500), 1024, two);
  EXPECT_GT(large.seconds, small.seconds);
  EXPECT_GT(levels.seconds, small.seconds);
  EXPECT_GT(large.output_bytes, small.output_bytes);
  EXPECT_GT(levels.output_bytes, small.output_bytes);
  EXPECT_GT(large.memory_bytes, small.memory_bytes);
  EXPECT_GE(levels.memory_bytes, small.memory_bytes);
}

TEST(ExpectedCost, LevelsShareWhatIsDoneOnce) {
  const std::vector<double> one{0.1}, other{2.5}, two{0.1, 2.5};
  const PlannedRegion region = region_of(5000, 2000);
  EXPECT_LT(expected_cost(region, 1024, two).seconds,
            expected_cost(region, 1024, one).seconds + expected_cost(region, 1024, other).seconds);
}

TEST(ExpectedCost, GrowsWithTheTreesOfWoods) {
  const std::vector<double> levels{0.1, 2.5};
  PlannedRegion region = region_of(1000, 500);
  const ExpectedCost bare = expected_cost(region, 1024, levels);
  region.file.own_trees = 10'000;
  const ExpectedCost wooded = expected_cost(region, 1024, levels);
  EXPECT_GT(wooded.seconds, bare.seconds);
  EXPECT_GT(wooded.memory_bytes, bare.memory_bytes + 100'000'000);
  EXPECT_GT(wooded.output_bytes, bare.output_bytes + 10'000'000);
}

// Tiles are baked one after the other.
TEST(ExpectedCost, WoodsOfManyTilesTakeTheMemoryOfOne) {
  const std::vector<double> levels{0.1, 2.5};
  PlannedRegion one = region_of(1000, 0), many = one;
  one.file.own_trees = 10'000;
  many.tiles = 25, many.file.own_trees = 250'000;
  const ExpectedCost of_one = expected_cost(one, 1024, levels), of_many = expected_cost(many, 1024, levels);
  EXPECT_LT(static_cast<double>(of_many.memory_bytes), 1.5 * static_cast<double>(of_one.memory_bytes));
  EXPECT_GT(of_many.output_bytes, 20 * of_one.output_bytes);
}

}  // namespace
}  // namespace citykiln::commands
