#include "compiler/geometry/grid_point_set.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"

namespace citykiln {
namespace {

TEST(GridPointSet, HoldsWhatWasInsertedAndNothingElse) {
  const RandomSequence draw(1, StableId{1}, "points");
  const auto point = [&](std::uint32_t i) {
    return GridPoint{static_cast<std::int64_t>(draw.below(2000, 2 * i)) - 1000,
                     static_cast<std::int64_t>(draw.below(2000, 2 * i + 1)) * 1024};
  };
  std::vector<GridPoint> inserted;
  GridPointSet set({});
  for (std::uint32_t i = 0; i < 5000; ++i) inserted.push_back(point(i)), set.insert(inserted.back());
  std::ranges::sort(inserted);
  int found = 0;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    EXPECT_EQ(set.contains(point(i)), std::ranges::binary_search(inserted, point(i)));
    found += set.contains(point(i));
  }
  EXPECT_GE(found, 5000);
  EXPECT_LT(found, 5200);
}

TEST(GridPointSet, BeginsWithTheGivenPoints) {
  const std::vector<GridPoint> points = {{0, 0}, {0, 1}, {-1, 0}, {0, 0}};
  const GridPointSet set(points);
  for (const GridPoint p : points) EXPECT_TRUE(set.contains(p));
  EXPECT_FALSE(set.contains({1, 0}));
  EXPECT_FALSE(GridPointSet({}).contains({0, 0}));
}

}  // namespace
}  // namespace citykiln
