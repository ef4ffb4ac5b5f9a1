#include "compiler/ground/cover/partition.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::ground {
namespace {

constexpr Box2 kPartitionedCell{{0, 0}, {16, 16}};

bool has_edge(const Partition& partition, GridPoint a, GridPoint b) {
  const Delaunay& net = partition.triangulation;
  for (std::uint32_t f = 0; f < net.faces().size(); ++f)
    for (int i = 0; i < 3; ++i)
      if (const auto [from, to] = edge_of(net, f, i); std::minmax(from, to) == std::minmax(a, b)) return true;
  return false;
}

// A thin quadrilateral, a third of a grid step beside the line between two of its corners, as Monaco's walls have them.
const std::vector<std::pair<GridPoint, GridPoint>> kQuadrilateral = {{{2000, 3000}, {2715, 2968}},
                                                                     {{2715, 2968}, {3970, 2911}},
                                                                     {{2000, 3000}, {3970, 2911}},
                                                                     {{2000, 3000}, {3970, 3911}},
                                                                     {{3970, 2911}, {3970, 3911}}};

TEST(PartitionOfBorders, WithoutRoundingALineIsAnEdgeHoweverCloseItPassesAVertex) {
  const auto all =
      partition_of_borders(empty_cell_borders(kPartitionedCell), {}, kPartitionedCell, kQuadrilateral, Rounding::kNone);
  ASSERT_TRUE(all);
  for (const auto& [a, b] : kQuadrilateral) EXPECT_TRUE(has_edge(*all, a, b));
}

TEST(PartitionOfBorders, WithRoundingALineIsBentThroughVerticesItPassesClosely) {
  const auto all = partition_of_borders(empty_cell_borders(kPartitionedCell), {}, kPartitionedCell, kQuadrilateral,
                                        Rounding::kInside);
  ASSERT_TRUE(all);
  EXPECT_FALSE(has_edge(*all, {2000, 3000}, {3970, 2911}));
}

TEST(PartitionOfBorders, WithoutRoundingThereIsNoneWhereLinesCross) {
  auto crossing = kQuadrilateral;
  crossing.push_back({{2700, 2900}, {2730, 4000}});
  EXPECT_FALSE(
      partition_of_borders(empty_cell_borders(kPartitionedCell), {}, kPartitionedCell, crossing, Rounding::kNone));
  EXPECT_TRUE(
      partition_of_borders(empty_cell_borders(kPartitionedCell), {}, kPartitionedCell, crossing, Rounding::kInside));
}

}  // namespace
}  // namespace citykiln::ground
