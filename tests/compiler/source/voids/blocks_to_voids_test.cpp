#include "compiler/source/voids/blocks_to_voids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/source/voids/fill_gaps.h"
#include "compiler/source/voids/spikes_to_voids.h"

namespace citykiln::source {
namespace {

using Land = std::function<double(double, double)>;

// Heights at whole columns and rows, 30 m apart.
Raster raster_over(int columns, int rows, const Land& land, double spacing_m = 30) {
  Raster raster;
  raster.columns = columns, raster.rows = rows, raster.file_spacing_m = spacing_m;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) raster.heights_m.push_back(static_cast<float>(land(column, row)));
  return raster;
}

// Each sample is the mean height of its cell, as radar measures it.
Raster measured_over(int columns, int rows, const Land& land) {
  constexpr int kParts = 8;
  return raster_over(columns, rows, [&](double column, double row) {
    double sum_m = 0;
    for (int i = 0; i < kParts * kParts; ++i)
      sum_m += land(column - 0.5 + (i % kParts + 0.5) / kParts, row - 0.5 + (i / kParts + 0.5) / kParts);
    return sum_m / (kParts * kParts);
  });
}

double slope_m(double column, double row) { return 300 + 4 * column - 2 * row + 3 * std::sin(column) * std::cos(row); }

// A slope with a block of `columns` by `rows` samples.
Raster with_block(int columns, int rows, double size_m) {
  return raster_over(30, 30, [=](double c, double r) {
    const bool is_inside = c >= 10 && c < 10 + columns && r >= 11 && r < 11 + rows;
    return slope_m(c, r) + (is_inside ? size_m : 0);
  });
}

std::vector<std::size_t> voids_in(const Raster& raster) {
  std::vector<std::size_t> voids;
  for (std::size_t i = 0; i < raster.heights_m.size(); ++i)
    if (std::isnan(raster.heights_m[i])) voids.push_back(i);
  return voids;
}

std::size_t removed_from(const Raster& raster) {
  Report report;
  return voids_in(blocks_to_voids(raster, report)).size();
}

TEST(BlocksToVoids, RemovesBlocksUpToSixSamplesWideWithOneFindingEach) {
  for (int columns = 1; columns <= kLargestBlock; ++columns) {
    for (int rows = 1; rows <= kLargestBlock; ++rows) {
      for (const double size_m : {150.0, -150.0}) {
        Report report;
        const Raster mended = blocks_to_voids(with_block(columns, rows, size_m), report);
        EXPECT_EQ(voids_in(mended).size(), static_cast<std::size_t>(columns * rows)) << columns << " " << rows;
        ASSERT_EQ(report.diagnoses().size(), 1u) << columns << " " << rows;
        EXPECT_EQ(report.diagnoses()[0].code, Code::kHeightSpike);
        EXPECT_NEAR(report.diagnoses()[0].size, 150, 15);
      }
    }
  }
}

TEST(BlocksToVoids, ThreeByTwoSamplesOfOneHeightOnASlopeAreFilledWithTheSlope) {
  const auto slope = [](double c, double) { return 308 + 0.6 * c; };
  const Raster broken = raster_over(
      41, 41, [&](double c, double r) { return c >= 21 && c <= 23 && (r == 18 || r == 19) ? 420 : slope(c, r); },
      29.27);
  Report report;
  const Raster mended = fill_voids(blocks_to_voids(spikes_to_voids(broken, report), report), report);
  for (int r = 0; r < 41; ++r)
    for (int c = 0; c < 41; ++c) EXPECT_NEAR(mended.at(c, r), slope(c, r), 0.01) << c << " " << r;
  EXPECT_EQ(report.counts()[Code::kHeightSpike], 1u);
}

TEST(BlocksToVoids, CornersAndGapsOfABlockAreNoMatter) {
  const Raster raster = raster_over(20, 20, [](double c, double r) {
    const bool is_inside = (c == 8 && r >= 8 && r < 12) || (r == 8 && c >= 8 && c < 11) || (c == 9 && r == 12);
    return slope_m(c, r) - (is_inside ? 200 : 0);
  });
  EXPECT_EQ(removed_from(raster), 7u);
}

TEST(BlocksToVoids, LargerAndLowerBlocksStay) {
  EXPECT_EQ(removed_from(with_block(kLargestBlock + 1, 2, 150)), 0u);
  EXPECT_EQ(removed_from(with_block(2, kLargestBlock + 1, -150)), 0u);
  EXPECT_EQ(removed_from(with_block(3, 3, 60)), 0u);
}

TEST(BlocksToVoids, CliffsRidgesGorgesWallsAndSummitsStay) {
  const Land lands[] = {
      [](double c, double r) { return 3000 - 150 * std::hypot(c - 20, r - 20); },
      [](double c, double r) { return 2000 - 150.0 * std::abs(c - r) + 3 * r; },
      [](double c, double r) { return r > 20 ? 500.0 : 2000 - 150.0 * std::abs(c - 20); },
      [](double c, double r) { return c + r / 3 > 25 ? 0.0 : 400.0 + c; },
      [](double c, double r) { return c + r == 40 ? 300.0 : 500.0; },
      [](double c, double) { return c == 20 ? 190.0 : 20.0; },
      // terraces in stairs, and a spur of a plateau that is four samples wide
      [](double c, double) { return 120 * std::floor(c / 4); },
      [](double c, double r) { return c < 10 || (c < 18 && r > 17 && r < 22) ? 300.0 : 0.0; },
  };
  for (const Land& land : lands) EXPECT_EQ(removed_from(raster_over(41, 41, land)), 0u);
}

TEST(BlocksToVoids, AQuarryOpenToOneSideStays) {
  // five samples wide, 200 m deep, with a ramp to the south
  const Land quarry = [](double c, double r) {
    if (c < 18 || c > 22 || r < 18) return 500.0;
    return r <= 22 ? 300.0 : std::min(500.0, 300 + 25 * (r - 22));
  };
  EXPECT_EQ(removed_from(raster_over(41, 41, quarry)), 0u);
}

TEST(BlocksToVoids, AQuarryInASlopeWithAHighWallOnOneSideStays) {
  const Land quarry = [](double c, double r) {
    const double land_m = 500 + 40 * (20 - r);
    return c >= 18 && c <= 22 && r >= 16 && r <= 20 ? std::min(land_m, 500.0) : land_m;
  };
  EXPECT_EQ(removed_from(raster_over(41, 41, quarry)), 0u);
}

// A tower of rock on level land, 2.6 to 5.2 samples wide: a turned ellipse with sheer walls, whose summit falls by a
// fifth to one side.
Land tower(const RandomSequence& draw) {
  const double column = draw.between(19, 21, 0), row = draw.between(19, 21, 1), turn = draw.between(0, 3.14, 2);
  const double wide = draw.between(1.3, 2.6, 3), deep = draw.between(1.3, 2.6, 4), high_m = draw.between(60, 300, 5);
  return [=](double c, double r) {
    const double x = (c - column) * std::cos(turn) + (r - row) * std::sin(turn);
    const double y = (r - row) * std::cos(turn) - (c - column) * std::sin(turn);
    const double from_middle = std::hypot(x / wide, y / deep);
    return from_middle > 1 ? 100.0 : 100 + high_m * (0.9 + 0.1 * x / wide);
  };
}

TEST(BlocksToVoids, TowersOfRockStayWhereSamplesAreMeansOfTheirCells) {
  int removed = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Land land = tower(RandomSequence(1, StableId{i}, "towers"));
    removed += removed_from(measured_over(41, 41, land)) > 0;
  }
  EXPECT_EQ(removed, 0);
}

TEST(BlocksToVoids, TowersWithScreeOrUnevenSummitsStay) {
  const Land with_scree = [](double c, double r) {
    const double away = std::max(std::abs(c - 20), std::abs(r - 20));
    return away <= 1.5 ? 250.0 : 100 + std::max(0.0, 100 - 40 * (away - 2));
  };
  const Land uneven = [](double c, double r) {
    return std::abs(c - 20) <= 1 && std::abs(r - 20) <= 1 ? 220 + 60 * (c - 20) + 20 * (r - 20) : 100.0;
  };
  EXPECT_EQ(removed_from(raster_over(41, 41, with_scree)), 0u);
  EXPECT_EQ(removed_from(raster_over(41, 41, uneven)), 0u);
}

TEST(BlocksToVoids, BlocksAtTheEdgeAndAmongVoidsStay) {
  const auto block = [](double c, double r) { return c < 3 && r >= 4 && r < 7 ? 400.0 : 100.0; };
  EXPECT_EQ(removed_from(raster_over(12, 12, block)), 0u);
  const auto island = [](double c, double r) {
    if (c >= 5 && c < 8 && r >= 5 && r < 8) return 400.0;
    return r > 8 ? 100.0 : double{kVoid};
  };
  const Raster among = raster_over(14, 14, island);
  EXPECT_EQ(removed_from(among), voids_in(among).size());
}

// Samples of exactly 0 between calm land, and a height between 0 and the land on two of their sides.
double with_zeros_m(double column, double row, double land_m) {
  if (row < 11 || row > 13) return land_m;
  if (column == 10 || column == 13) return 0.4 * land_m;
  return column > 10 && column < 13 ? 0 : land_m;
}

TEST(BlocksToVoids, ZerosInCalmLandAreRemovedWithTheSamplesTheyAreMixedInto) {
  const auto at_height = [](double land_m) {
    return raster_over(
        30, 30, [=](double c, double r) { return with_zeros_m(c, r, land_m + 0.3 * std::sin(c)); }, 10);
  };
  Report report;
  const Raster mended = blocks_to_voids(at_height(14), report);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_NEAR(report.diagnoses()[0].size, 14, 1);
  EXPECT_EQ(voids_in(mended).size(), 12u);
  EXPECT_EQ(removed_from(at_height(-14)), 12u);
  EXPECT_EQ(removed_from(at_height(8)), 0u) << "shallow holes may be real";
}

TEST(BlocksToVoids, HolesThatEndAboveZeroAndZerosBelowAHillsideStay) {
  const auto hole = [](double c, double r) { return with_zeros_m(c, r, 14) + 0.1; };
  EXPECT_EQ(removed_from(raster_over(30, 30, hole, 10)), 0u);
  const auto cove = [](double c, double r) { return with_zeros_m(c, r, c < 13 ? 3 : 20); };
  EXPECT_EQ(removed_from(raster_over(30, 30, cove, 10)), 0u);
}

TEST(BlocksToVoids, AWindowEqualsThatPartOfTheWhole) {
  const Raster whole = raster_over(90, 90, [](double c, double r) {
    const int i = static_cast<int>(c) / 11, j = static_cast<int>(r) / 11;
    const bool is_block = std::fmod(c, 11) < 1 + i % kLargestBlock && std::fmod(r, 11) < 1 + j % kLargestBlock;
    return slope_m(c, r) + (is_block ? (i + j) % 2 ? 130 : -170 : 0);
  });
  Report report;
  const Raster mended = blocks_to_voids(whole, report);
  EXPECT_GT(report.diagnoses().size(), 30u);
  for (int first = 1; first < 40; ++first) {
    const Raster window = blocks_to_voids(
        raster_over(50, 50, [&](double c, double r) { return whole.at(int(c) + first, int(r) + first); }), report);
    for (int r = kBlockInfluence; r < 50 - kBlockInfluence; ++r)
      for (int c = kBlockInfluence; c < 50 - kBlockInfluence; ++c)
        EXPECT_EQ(std::isnan(window.at(c, r)), std::isnan(mended.at(c + first, r + first))) << first << c << r;
  }
}

TEST(BlocksToVoids, AcceptsRastersWithoutSamples) {
  EXPECT_EQ(removed_from(Raster{}), 0u);
  EXPECT_EQ(removed_from(raster_over(1, 1, [](double, double) { return 1; })), 0u);
  EXPECT_EQ(removed_from(raster_over(3, 1, [](double c, double) { return c == 1 ? 1e6 : 0; })), 0u);
}

}  // namespace
}  // namespace citykiln::source
