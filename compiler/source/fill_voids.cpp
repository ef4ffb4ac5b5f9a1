// Laplace's equation on the void samples, by cascadic multigrid: the raster is halved until no void is left, then each
// void takes the value of the coarser level and is relaxed there, from the coarsest level to the finest. F. Bornemann,
// P. Deuflhard, "The cascadic multigrid method for elliptic problems", Numerische Mathematik 75, 1996.
#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/source/read_raster.h"

namespace citykiln::source {
namespace {

constexpr double kVoid = std::numeric_limits<double>::quiet_NaN();
// over-relaxation: between plain Gauss-Seidel (1) and the limit of convergence (2); the start is near the solution
// already
constexpr double kRelaxation = 1.7;
// sweeps end when no sample moves by more than a tenth of the quantum of heights (2^-10 m), or here
constexpr double kStill_m = 1e-4;
constexpr int kMostSweeps = 2000;

struct Grid {
  int columns = 0, rows = 0;
  std::vector<double> heights_m;
  std::vector<std::size_t> voids;  // in row order
};

Grid grid_of(const Raster& raster) {
  Grid grid{raster.columns, raster.rows, {raster.heights_m.begin(), raster.heights_m.end()}, {}};
  for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
    if (std::isnan(grid.heights_m[i])) grid.voids.push_back(i);
  }
  return grid;
}

// The mean of the samples of a block of two by two, a void where all are.
double mean_of_block(const Grid& fine, int column, int row) {
  double sum = 0;
  int count = 0;
  for (int r = 2 * row; r < std::min(2 * row + 2, fine.rows); ++r) {
    for (int c = 2 * column; c < std::min(2 * column + 2, fine.columns); ++c) {
      const double height = fine.heights_m[static_cast<std::size_t>(r) * fine.columns + c];
      if (std::isnan(height)) continue;
      sum += height;
      ++count;
    }
  }
  return count > 0 ? sum / count : kVoid;
}

Grid halve(const Grid& fine) {
  Grid coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}, {}};
  coarse.heights_m.reserve(static_cast<std::size_t>(coarse.columns) * coarse.rows);
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      const double height = mean_of_block(fine, column, row);
      if (std::isnan(height)) coarse.voids.push_back(coarse.heights_m.size());
      coarse.heights_m.push_back(height);
    }
  }
  return coarse;
}

// The mean of the up to four neighbours.
double mean_of_neighbours(const Grid& grid, std::size_t at) {
  const int column = static_cast<int>(at % grid.columns), row = static_cast<int>(at / grid.columns);
  double sum = 0;
  int count = 0;
  const auto add = [&](bool is_inside, std::size_t neighbour) {
    if (!is_inside) return;
    sum += grid.heights_m[neighbour];
    ++count;
  };
  add(row > 0, at - grid.columns);
  add(column > 0, at - 1);
  add(column + 1 < grid.columns, at + 1);
  add(row + 1 < grid.rows, at + grid.columns);
  return sum / count;
}

// Sweeps over the voids, which all have a first guess, until they are still.
void relax(Grid& grid) {
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double largest_m = 0;
    for (const std::size_t at : grid.voids) {
      const double change = kRelaxation * (mean_of_neighbours(grid, at) - grid.heights_m[at]);
      grid.heights_m[at] += change;
      largest_m = std::max(largest_m, std::abs(change));
    }
    if (largest_m < kStill_m) return;
  }
}

// Solves a level by way of the coarser one.
void solve(Grid& grid) {
  if (grid.voids.empty()) return;
  if (grid.voids.size() == grid.heights_m.size()) {
    std::fill(grid.heights_m.begin(), grid.heights_m.end(), 0.0);  // no rim to start from
    return;
  }
  Grid coarse = halve(grid);
  solve(coarse);
  for (const std::size_t at : grid.voids) {
    const std::size_t column = at % grid.columns / 2, row = at / grid.columns / 2;
    grid.heights_m[at] = coarse.heights_m[row * coarse.columns + column];
  }
  relax(grid);
}

}  // namespace

Raster fill_voids(Raster raster, Report& report) {
  Grid grid = grid_of(raster);
  if (grid.voids.empty()) return raster;
  solve(grid);
  for (const std::size_t at : grid.voids) raster.heights_m[at] = static_cast<float>(grid.heights_m[at]);
  report.add(Code::kVoidFilled, OsmId{}, static_cast<double>(grid.voids.size()));
  return raster;
}

}  // namespace citykiln::source
