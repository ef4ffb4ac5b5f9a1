#include "compiler/impostor/mip_opacity.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace citykiln::impostor {
namespace {

// Offsets from the cutoff are in steps of opacity, from between its last transparent and its first opaque value.
constexpr float kMiddle = kAlphaCutoff - 0.5f, kMostAbove = 255 - kMiddle, kMostBelow = -kMiddle;
// The least distance of a texel from the cutoff, on the picture itself and on smaller levels, whose means readers round
// once a level.
constexpr float kMargin = 0.75f, kMeanMargin = 1.0f;
// Rounds of projections while the share is fitted, and for the last one; the share changes little after two fits.
constexpr int kRoughSweeps = 2, kSweeps = 12, kFits = 2;

CoverageGrid halved_grid(const CoverageGrid& grid) {
  CoverageGrid half{grid.columns / 2, grid.rows / 2, {}};
  half.share.reserve(grid.share.size() / 4);
  for (std::size_t row = 0; row < half.rows; ++row)
    for (std::size_t column = 0; column < half.columns; ++column) {
      const std::size_t at = 2 * row * grid.columns + 2 * column, below = at + grid.columns;
      half.share.push_back((grid.share[at] + grid.share[at + 1] + grid.share[below] + grid.share[below + 1]) / 4);
    }
  return half;
}

// Coverage, raised by that of the eight neighbours to rank texels of equal coverage.
std::vector<float> ranks_of(const CoverageGrid& grid) {
  constexpr float kOfNeighbours = 1.0f / 64;
  std::vector<float> ranks = grid.share;
  const auto columns = static_cast<int>(grid.columns), rows = static_cast<int>(grid.rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (int y = std::max(0, row - 1); y <= std::min(rows - 1, row + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(columns - 1, column + 1); ++x)
          ranks[static_cast<std::size_t>(row * columns + column)] +=
              kOfNeighbours * grid.share[static_cast<std::size_t>(y * columns + x)];
  return ranks;
}

// One level: its coverage, and which texels are to be opaque.
struct Level {
  std::uint32_t columns, rows, side;  // texels of the level; texels of the picture along a side of one of these
  std::vector<float> ranks;
  std::vector<std::uint8_t> is_opaque{};
};

std::vector<Level> levels_of(const CoverageGrid& coverage) {
  std::vector<Level> levels{{coverage.columns, coverage.rows, 1, ranks_of(coverage)}};
  CoverageGrid grid = coverage;
  for (int i = halvings_of(grid.columns, grid.rows); i > 0; --i) {
    grid = halved_grid(grid);
    levels.push_back({grid.columns, grid.rows, 2 * levels.back().side, ranks_of(grid)});
  }
  return levels;
}

// Marks the texels of the highest ranks; at least one.
void mark_opaque(Level& level, double share) {
  const auto count = static_cast<std::size_t>(share * static_cast<double>(level.ranks.size()) + 0.5);
  std::vector<float> sorted = level.ranks;
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(count, 1, sorted.size()) - 1);
  std::ranges::nth_element(sorted, last, std::ranges::greater{});
  level.is_opaque.clear();
  for (const float rank : level.ranks) level.is_opaque.push_back(rank >= *last);
}

// Opacities as offsets, and the ends of their ranges.
struct Offsets {
  std::uint32_t columns, rows;
  std::vector<float> at;
  std::span<const std::uint8_t> is_opaque;    // of the picture itself
  std::vector<std::uint8_t> agreeing_levels;  // on so many levels from the first on, the texel's is as opaque as it is

  float highest(std::size_t i) const { return is_opaque[i] != 0 ? kMostAbove : -kMargin; }
  float lowest(std::size_t i) const { return is_opaque[i] != 0 ? kMargin : kMostBelow; }
};

std::vector<std::uint8_t> agreeing_levels_of(std::span<const Level> levels) {
  const Level& picture = levels.front();
  std::vector<std::uint8_t> agreeing(picture.is_opaque.size());
  for (std::uint32_t row = 0; row < picture.rows; ++row)
    for (std::uint32_t column = 0; column < picture.columns; ++column) {
      const std::size_t i = std::size_t{row} * picture.columns + column;
      const auto agrees = [&](const Level& level) {
        return level.is_opaque[std::size_t{row / level.side} * level.columns + column / level.side] ==
               picture.is_opaque[i];
      };
      agreeing[i] = static_cast<std::uint8_t>(std::ranges::find_if_not(levels, agrees) - levels.begin());
    }
  return agreeing;
}

// The texels of the picture below one of a level.
struct Block {
  std::size_t first;
  std::uint32_t columns, rows;
  std::size_t level;
  bool is_opaque;
};

template <typename Act>
void for_each_texel(const Offsets& offsets, const Block& block, Act act) {
  for (std::uint32_t y = 0; y < block.rows; ++y)
    for (std::uint32_t x = 0; x < block.columns; ++x) act(block.first + std::size_t{y} * offsets.columns + x);
}

// Moves texels that may move towards an end of their ranges, by equal shares of the way, until the sum is as wanted.
template <typename MayMove>
float move_some(Offsets& offsets, const Block& block, float sum, float wanted, MayMove may_move) {
  const auto room = [&](std::size_t i) {
    return (block.is_opaque ? offsets.highest(i) : offsets.lowest(i)) - offsets.at[i];
  };
  float most = 0;
  for_each_texel(offsets, block, [&](std::size_t i) { most += may_move(i) ? room(i) : 0; });
  if (most == 0) return sum;
  const float share = std::min(1.0f, (wanted - sum) / most);
  for_each_texel(offsets, block, [&](std::size_t i) { offsets.at[i] += may_move(i) ? share * room(i) : 0; });
  return sum + share * most;
}

// Moves a block's mean to a margin on its side of the cutoff. First those texels move that are on that side on all
// levels below, where this cannot be wrong.
void move_block(Offsets& offsets, const Block& block) {
  const float texels = static_cast<float>(block.columns) * static_cast<float>(block.rows);
  const float wanted = texels * (block.is_opaque ? kMeanMargin : -kMeanMargin);
  const auto is_reached = [&](float sum) { return block.is_opaque ? sum >= wanted : sum <= wanted; };
  float sum = 0;
  for_each_texel(offsets, block, [&](std::size_t i) { sum += offsets.at[i]; });
  if (is_reached(sum)) return;
  sum = move_some(offsets, block, sum, wanted, [&](std::size_t i) {
    return (offsets.is_opaque[i] != 0) == block.is_opaque && offsets.agreeing_levels[i] >= block.level;
  });
  if (!is_reached(sum)) move_some(offsets, block, sum, wanted, [](std::size_t) { return true; });
}

void sweep(Offsets& offsets, std::span<const Level> levels) {
  for (std::size_t number = 1; number < levels.size(); ++number) {
    const Level& level = levels[number];
    for (std::size_t row = 0; row < level.rows; ++row)
      for (std::size_t column = 0; column < level.columns; ++column)
        move_block(offsets, {(row * offsets.columns + column) * level.side, level.side, level.side, number,
                             level.is_opaque[row * level.columns + column] != 0});
  }
  move_block(offsets, {0, offsets.columns, offsets.rows, levels.size(), true});
}

// The least share of texels to be opaque, of the covered share: bare twigs would vanish from smaller levels.
constexpr double kLeastShare = 0.6;

// Offsets before any is moved: their mean is 0, and texels that are covered in part are near the cutoff.
void start(Offsets& offsets, const CoverageGrid& coverage, double share) {
  constexpr float kAbove = 60;
  const float below = std::min(kAbove, static_cast<float>(kAbove * share / std::max(1 - share, 1e-3)));
  for (std::size_t i = 0; i < offsets.at.size(); ++i) {
    const float covered = coverage.share[i];
    offsets.at[i] = offsets.is_opaque[i] != 0 ? std::max(kMargin, kAbove * (2 * covered - 1))
                                              : std::min(-kMargin, -below * (1 - 2 * covered));
  }
}

Offsets solved(const CoverageGrid& coverage, std::vector<Level>& levels, double share, int sweeps) {
  for (Level& level : levels) mark_opaque(level, share);
  Offsets offsets{coverage.columns, coverage.rows, std::vector<float>(coverage.share.size()), levels.front().is_opaque,
                  agreeing_levels_of(levels)};
  start(offsets, coverage, share);
  for (int i = 0; i < sweeps; ++i) sweep(offsets, levels);
  return offsets;
}

// The share of the picture that is opaque where readers interpolate between texels, by four samples a texel.
double interpolated_share(const Offsets& offsets) {
  const auto columns = static_cast<int>(offsets.columns), rows = static_cast<int>(offsets.rows);
  const auto at = [&](int column, int row) {
    return offsets
        .at[static_cast<std::size_t>(std::clamp(row, 0, rows - 1) * columns + std::clamp(column, 0, columns - 1))];
  };
  std::int64_t opaque = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (const int y : {row - 1, row + 1})
        for (const int x : {column - 1, column + 1})
          opaque += 9 * at(column, row) + 3 * at(x, row) + 3 * at(column, y) + at(x, y) >= 0;
  return static_cast<double>(opaque) / (4.0 * columns * rows);
}

std::uint8_t opacity_of(float offset) {
  return static_cast<std::uint8_t>(std::clamp(offset + kMiddle + 0.5f, 0.0f, 255.0f));
}

}  // namespace

int halvings_of(std::uint32_t columns, std::uint32_t rows) {
  assert(columns > 0 && rows > 0);
  return std::min(std::countr_zero(columns), std::countr_zero(rows));
}

std::vector<std::uint8_t> mip_opacity(const CoverageGrid& coverage) {
  assert(coverage.share.size() == std::size_t{coverage.columns} * coverage.rows && !coverage.share.empty());
  double covered = 0;
  for (const float share : coverage.share) covered += share;
  covered /= static_cast<double>(coverage.share.size());
  std::vector<std::uint8_t> opacity(coverage.share.size());
  if (!(covered > 0)) return opacity;
  std::vector<Level> levels = levels_of(coverage);
  double share = covered;
  for (int i = 0; i < kFits; ++i) {
    const double shown = interpolated_share(solved(coverage, levels, share, kRoughSweeps));
    share = std::clamp(share * covered / std::max(shown, 1e-3), kLeastShare * covered, 1.0);
  }
  const Offsets offsets = solved(coverage, levels, share, kSweeps);
  std::ranges::transform(offsets.at, opacity.begin(), opacity_of);
  return opacity;
}

}  // namespace citykiln::impostor
