#include "compiler/impostor/mip_opacity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "tests/compiler/impostor/mip_levels.h"

namespace citykiln::impostor {
namespace {

// Discs of a few texels at random places.
CoverageGrid discs(std::uint32_t columns, std::uint32_t rows, int count, std::uint32_t seed) {
  std::mt19937 dice(seed);
  CoverageGrid grid{columns, rows, std::vector<float>(std::size_t{columns} * rows)};
  for (int i = 0; i < count; ++i) {
    const double x = dice() % columns, y = dice() % rows, radius = 1.5 + dice() % 3;
    for (std::uint32_t row = 0; row < rows; ++row)
      for (std::uint32_t column = 0; column < columns; ++column) {
        const double off = std::sqrt((column - x) * (column - x) + (row - y) * (row - y));
        float& share = grid.share[std::size_t{row} * columns + column];
        share = std::max(share, static_cast<float>(std::clamp(radius - off + 0.5, 0.0, 1.0)));
      }
  }
  return grid;
}

TEST(MipOpacity, KeepsTheCoverageOnEveryLevel) {
  int dense = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed)
    for (const int count : {3, 12, 40, 90, 120}) {
      MipLevel level{64, 96, mip_opacity(discs(64, 96, count, seed))};
      const double covered = opaque_share(level);
      EXPECT_GT(covered, 0);
      for (int i = halvings_of(64, 96); i > 0; --i) {
        level = halved(level);
        EXPECT_GT(opaque_share(level), 0) << seed << ' ' << count;
        if (level.opacity.size() < 64) continue;
        EXPECT_GT(opaque_share(level), covered - 0.05) << seed << ' ' << count << ' ' << level.columns;
        if (covered < 0.25) continue;
        ++dense;
        EXPECT_LT(opaque_share(level), covered + 0.05) << seed << ' ' << count << ' ' << level.columns;
      }
    }
  EXPECT_GT(dense, 50);
}

TEST(MipOpacity, HasTheCoveredAreaWhereReadersInterpolate) {
  for (std::uint32_t seed = 0; seed < 30; ++seed)
    for (const int count : {12, 40, 120}) {
      const CoverageGrid grid = discs(64, 64, count, seed);
      double covered = 0;
      for (const float share : grid.share) covered += share / static_cast<double>(grid.share.size());
      EXPECT_NEAR(interpolated_share({64, 64, mip_opacity(grid)}), covered, 0.02) << seed << ' ' << count;
    }
}

TEST(MipOpacity, IsAllOrNothingWhereCoverageIs) {
  const auto none = mip_opacity({16, 16, std::vector<float>(256, 0.0f)});
  EXPECT_EQ(std::ranges::count(none, 0), 256);
  const auto all = mip_opacity({16, 16, std::vector<float>(256, 1.0f)});
  EXPECT_GE(*std::ranges::min_element(all), kAlphaCutoff);
}

}  // namespace
}  // namespace citykiln::impostor
