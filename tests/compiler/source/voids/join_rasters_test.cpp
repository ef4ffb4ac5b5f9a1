#include "compiler/source/voids/join_rasters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace citykiln::source {
namespace {

// A degree of land, some of it void.
Raster degree(int columns, int rows) {
  Raster raster;
  raster.file_name = "whole", raster.credit = "someone";
  raster.columns = columns, raster.rows = rows;
  raster.from_grid = {1.0 / 3, 1.0 / 1200, 0, 43.1, 0, -1.0 / 1200};
  for (int i = 0; i < columns * rows; ++i) raster.heights_m.push_back(i % 11 == 3 ? kVoid : static_cast<float>(i));
  return raster;
}

Raster cut(const Raster& whole, int column, int row, int columns, int rows) {
  Raster part = whole;
  part.columns = columns, part.rows = rows;
  part.from_grid[0] += column * part.from_grid[1], part.from_grid[3] += row * part.from_grid[5];
  part.heights_m.clear();
  for (int r = row; r < row + rows; ++r) {
    for (int c = column; c < column + columns; ++c) part.heights_m.push_back(whole.at(c, r));
  }
  return part;
}

bool same_samples(const Raster& a, const Raster& b) {
  const auto same = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.columns == b.columns && a.rows == b.rows && a.from_grid == b.from_grid &&
         std::ranges::equal(a.heights_m, b.heights_m, same);
}

TEST(JoinRasters, RestoresARasterCutAlongAMeridian) {
  const Raster whole = degree(40, 30);
  for (const int overlap : {0, 1, 5}) {
    const Raster west = cut(whole, 0, 0, 17 + overlap, 30), east = cut(whole, 17, 0, 23, 30);
    for (const auto& parts : {std::vector{west, east}, std::vector{east, west}}) {
      const std::vector<Raster> joined = join_rasters(parts);
      ASSERT_EQ(joined.size(), 1u);
      EXPECT_TRUE(same_samples(joined[0], whole)) << overlap;
    }
  }
}

TEST(JoinRasters, RestoresFourQuartersInAnyOrder) {
  const Raster whole = degree(40, 30);
  std::vector<Raster> parts = {cut(whole, 0, 0, 17, 12), cut(whole, 17, 0, 23, 12), cut(whole, 0, 12, 17, 18),
                               cut(whole, 17, 12, 23, 18)};
  std::vector<int> order = {0, 1, 2, 3};
  do {
    const std::vector<Raster> joined =
        join_rasters({parts[order[0]], parts[order[1]], parts[order[2]], parts[order[3]]});
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_TRUE(same_samples(joined[0], whole));
  } while (std::ranges::next_permutation(order).found);
}

TEST(JoinRasters, DoesNotJoinThreeQuartersSinceThatWouldCreateVoids) {
  const Raster whole = degree(40, 30);
  const std::vector<Raster> joined =
      join_rasters({cut(whole, 0, 0, 17, 12), cut(whole, 0, 12, 17, 18), cut(whole, 17, 0, 23, 12)});
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].rows, 30);
}

TEST(JoinRasters, TakesTheFirstSampleInOverlaps) {
  Raster first = degree(10, 4), second = degree(10, 4);
  for (float& height_m : second.heights_m) height_m = -1;
  second.credit = "another";
  const std::vector<Raster> joined = join_rasters({first, second});
  ASSERT_EQ(joined.size(), 1u);
  for (std::size_t i = 0; i < first.heights_m.size(); ++i) {
    EXPECT_EQ(joined[0].heights_m[i], std::isnan(first.heights_m[i]) ? -1 : first.heights_m[i]);
  }
  EXPECT_EQ(joined[0].credit, "someone");
}

TEST(JoinRasters, TheSpacingForMendingIsTheSmallestOfTheParts) {
  const Raster whole = degree(40, 30);
  Raster north = cut(whole, 0, 0, 40, 12), south = cut(whole, 0, 12, 40, 18);
  north.file_spacing_m = 67, south.file_spacing_m = 68;
  for (const auto& parts : {std::vector{north, south}, std::vector{south, north}})
    EXPECT_EQ(join_rasters(parts).front().file_spacing_m, 67);
}

TEST(JoinRasters, KeepsOtherGridsApartAndInOrder) {
  const Raster whole = degree(40, 30), west = cut(whole, 0, 0, 17, 30), east = cut(whole, 17, 0, 23, 30);
  Raster shifted = east, finer = east, elsewhere = east, other_system = east;
  shifted.from_grid[0] += 0.5 / 1200;
  finer.from_grid[1] /= 2;
  elsewhere.from_grid[0] += 1;
  other_system.system_wkt = "another";
  for (const Raster& other : {shifted, finer, elsewhere, other_system}) {
    EXPECT_EQ(join_rasters({west, other}).size(), 2u);
  }
  // what lies between two parts in the list comes before the second: it keeps its place
  const std::vector<Raster> kept = join_rasters({west, finer, east});
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[1].from_grid, finer.from_grid);
}

TEST(JoinRasters, AcceptsEmptyInput) {
  EXPECT_TRUE(join_rasters({}).empty());
  Raster empty;
  EXPECT_EQ(join_rasters({empty, empty}).size(), 2u);
  const Raster whole = degree(40, 30), west = cut(whole, 0, 0, 17, 30), east = cut(whole, 17, 0, 23, 30);
  Raster outside = degree(0, 0);
  EXPECT_EQ(join_rasters({west, outside, east}).size(), 2u);
}

}  // namespace
}  // namespace citykiln::source
