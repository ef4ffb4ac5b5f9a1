// Solves Laplace's equation on the void samples by multigrid. The initial guess comes from block means on ever coarser
// grids; V-cycles of Gauss-Seidel sweeps then reduce the residual by the same factor for small and large holes.
// Source: W. Briggs, V. E. Henson, S. McCormick, "A Multigrid Tutorial", SIAM 2000, chapters 3 (cycles) and 4
// (cell-centred grids).
#include "compiler/source/voids/fill_gaps.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::source {
namespace {

// one sweep smooths errors with wavelengths of a sample or two, which the next coarser grid cannot represent
constexpr int kSweeps = 2;
// Cycles end when every sample is within the height quantum of the mean of its neighbours, or after kMaxCycles. One
// cycle reduces that distance to a fifth, or to four fifths for holes at the raster's edge.
constexpr double kConvergence_m = 0x1p-10;
constexpr int kMaxCycles = 30;

struct Cell {
  int column = 0, row = 0;
};

// The equation of each void: value - mean of its neighbours = right side. All other values are fixed.
struct Grid {
  int columns = 0, rows = 0;
  std::vector<double> values;
  std::vector<double> right_sides;  // empty: all 0
  std::vector<Cell> voids;          // in row order

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
  double right_side(std::size_t at) const { return right_sides.empty() ? 0 : right_sides[at]; }
};

// ---- one grid ----

// The mean of the neighbours inside the raster (a free boundary at its edge).
double mean_of_neighbours(const Grid& grid, Cell cell) {
  const double* value = grid.values.data() + grid.index(cell.column, cell.row);
  const bool has_west = cell.column > 0, has_east = cell.column + 1 < grid.columns;
  const bool has_north = cell.row > 0, has_south = cell.row + 1 < grid.rows;
  if (has_west && has_east && has_north && has_south) {
    return 0.25 * (value[-1] + value[1] + value[-grid.columns] + value[grid.columns]);
  }
  const double sum = (has_west ? value[-1] : 0) + (has_east ? value[1] : 0) + (has_north ? value[-grid.columns] : 0) +
                     (has_south ? value[grid.columns] : 0);
  return sum / (has_west + has_east + has_north + has_south);
}

void relax(Grid& grid, int times) {
  for (int i = 0; i < times; ++i) {
    for (const Cell cell : grid.voids) {
      const std::size_t at = grid.index(cell.column, cell.row);
      grid.values[at] = mean_of_neighbours(grid, cell) + grid.right_side(at);
    }
  }
}

double residual(const Grid& grid, Cell cell) {
  const std::size_t at = grid.index(cell.column, cell.row);
  return grid.right_side(at) + mean_of_neighbours(grid, cell) - grid.values[at];
}

double largest_residual(const Grid& grid) {
  double largest = 0;
  for (const Cell cell : grid.voids) largest = std::max(largest, std::abs(residual(grid, cell)));
  return largest;
}

// ---- between grids: each coarse cell is a block of two by two ----

Grid coarse_grid_size(const Grid& fine) {
  Grid coarse;
  coarse.columns = (fine.columns + 1) / 2;
  coarse.rows = (fine.rows + 1) / 2;
  return coarse;
}

// Calls `look(index)` for the one to four cells of a block.
template <typename Look>
void for_each_in_block(const Grid& fine, int column, int row, Look look) {
  for (int r = 2 * row; r < std::min(2 * row + 2, fine.rows); ++r) {
    for (int c = 2 * column; c < std::min(2 * column + 2, fine.columns); ++c) look(fine.index(c, r));
  }
}

// The coarse value at a fine cell, interpolated bilinearly between the four nearest coarse cells.
double interpolate(const Grid& coarse, Cell fine) {
  const int column = fine.column / 2, row = fine.row / 2;
  const int beside = std::clamp(column + (fine.column % 2 == 0 ? -1 : 1), 0, coarse.columns - 1);
  const int above = std::clamp(row + (fine.row % 2 == 0 ? -1 : 1), 0, coarse.rows - 1);
  const auto along_row = [&](int r) {
    return 0.75 * coarse.values[coarse.index(column, r)] + 0.25 * coarse.values[coarse.index(beside, r)];
  };
  return 0.75 * along_row(row) + 0.25 * along_row(above);
}

// ---- initial guess ----

// Each block takes the mean of its samples; blocks without a sample are the voids of the coarse grid.
Grid means_of_blocks(const Grid& fine) {
  Grid coarse = coarse_grid_size(fine);
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      double sum = 0;
      int count = 0;
      for_each_in_block(fine, column, row, [&](std::size_t at) {
        if (std::isnan(fine.values[at])) return;
        sum += fine.values[at];
        ++count;
      });
      if (count == 0) coarse.voids.push_back({column, row});
      coarse.values.push_back(count > 0 ? sum / count : kVoid);
    }
  }
  return coarse;
}

// At least one cell must have a value.
void set_initial_guess(Grid& grid) {
  if (grid.voids.empty()) return;
  Grid coarse = means_of_blocks(grid);
  set_initial_guess(coarse);
  for (const Cell cell : grid.voids) grid.values[grid.index(cell.column, cell.row)] = interpolate(coarse, cell);
  relax(grid, kSweeps);
}

// ---- solution ----

// The equation of the correction. Its unknowns are the blocks that consist of voids only; elsewhere the correction is
// 0. The right side is four times the block's mean residual, since the squared grid step is four times as large.
Grid coarse_of(const Grid& fine) {
  Grid coarse = coarse_grid_size(fine);
  const std::size_t size = static_cast<std::size_t>(coarse.columns) * coarse.rows;
  coarse.values.assign(size, 0);
  coarse.right_sides.assign(size, 0);
  std::vector<std::uint8_t> counts(size, 0);
  for (const Cell cell : fine.voids) {
    const std::size_t at = coarse.index(cell.column / 2, cell.row / 2);
    coarse.right_sides[at] += residual(fine, cell);
    ++counts[at];
  }
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      const std::size_t at = coarse.index(column, row);
      int block_size = 0;
      for_each_in_block(fine, column, row, [&](std::size_t) { ++block_size; });
      coarse.right_sides[at] *= 4.0 / block_size;
      if (counts[at] == block_size) coarse.voids.push_back({column, row});
    }
  }
  return coarse;
}

void v_cycle(Grid& grid) {
  relax(grid, kSweeps);
  Grid coarse = coarse_of(grid);
  if (!coarse.voids.empty()) {
    v_cycle(coarse);
    for (const Cell cell : grid.voids) grid.values[grid.index(cell.column, cell.row)] += interpolate(coarse, cell);
  }
  relax(grid, kSweeps);
}

Grid grid_of(const Raster& raster) {
  Grid grid{raster.columns, raster.rows, {raster.heights_m.begin(), raster.heights_m.end()}, {}, {}};
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (std::isnan(raster.at(column, row))) grid.voids.push_back({column, row});
    }
  }
  return grid;
}

void solve(Grid& grid) {
  if (grid.voids.size() == grid.values.size()) {
    std::fill(grid.values.begin(), grid.values.end(), 0.0);  // no boundary values
    return;
  }
  set_initial_guess(grid);
  for (int i = 0; i < kMaxCycles && largest_residual(grid) > kConvergence_m; ++i) v_cycle(grid);
}

// For each element of a row, the index of the nearest known element, the smaller one of two; -1 if none is known.
template <typename IsKnown>
std::vector<int> nearest_known(int count, IsKnown is_known) {
  std::vector<int> nearest;
  for (int i = 0, before = -1; i < count; ++i) nearest.push_back(is_known(i) ? before = i : before);
  for (int i = count - 1, after = -1; i >= 0; --i) {
    if (is_known(i)) after = i;
    if (after >= 0 && (nearest[i] < 0 || after - i < i - nearest[i])) nearest[i] = after;
  }
  return nearest;
}

}  // namespace

Raster fill_voids(Raster raster, Report& report) {
  assert(raster.has_all_samples());
  Grid grid = grid_of(raster);
  if (grid.voids.empty()) return raster;
  solve(grid);
  for (const Cell cell : grid.voids) {
    const std::size_t at = grid.index(cell.column, cell.row);
    raster.heights_m[at] = static_cast<float>(grid.values[at]);
  }
  report.add(Code::kVoidFilled, OsmId{}, static_cast<double>(grid.voids.size()));
  return raster;
}

std::size_t fill_uncovered(std::span<std::int32_t> heights, const std::vector<bool>& known, int columns) {
  assert(columns > 0 && heights.size() % static_cast<std::size_t>(columns) == 0 && known.size() == heights.size());
  const int rows = static_cast<int>(heights.size() / static_cast<std::size_t>(columns));
  const auto index = [&](int column, int row) { return static_cast<std::size_t>(row) * columns + column; };
  std::vector<bool> is_row_known(rows);
  for (int row = 0; row < rows; ++row) {
    const auto nearest = nearest_known(columns, [&](int column) { return known[index(column, row)]; });
    is_row_known[row] = nearest.front() >= 0;
    for (int column = 0; is_row_known[row] && column < columns; ++column)
      heights[index(column, row)] = heights[index(nearest[column], row)];
  }
  const auto nearest_row = nearest_known(rows, [&](int row) { return is_row_known[row]; });
  for (int row = 0; row < rows; ++row)
    if (!is_row_known[row] && nearest_row[row] >= 0)
      std::copy_n(heights.begin() + index(0, nearest_row[row]), columns, heights.begin() + index(0, row));
  return static_cast<std::size_t>(std::ranges::count(known, false));
}

}  // namespace citykiln::source
