#include "compiler/source/voids/blocks_to_voids.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace citykiln::source {
namespace {

// The constants leave a wide margin to nature: on the real heightmaps of the tests a quarter of the slope, with kUneven
// 2 and kRough 1/3, finds no natural place either.
constexpr double kLeastStep_m = 12, kLeastStepSlope = 2;
// largest ratio of the block's distances from the plane of the land
constexpr double kUneven = 1.5;
// largest distance of the land from its plane, as a share of the block's
constexpr double kRough = 0.25;
// least share of the edges of a block behind which a height is known
constexpr double kKnownEdges = 0.75;
// width of the land around a block that is examined, in samples
constexpr int kLand = 2;
// width of the samples around zeros into which these may be mixed
constexpr int kMixed = 1;
static_assert(kLargestBlock - 1 + kMixed + kLand <= kBlockInfluence);
// least distance of the land around zeros from 0
constexpr double kLeastDepth_m = 6, kLeastDepthSlope = 0.5;
// programs that interpolate leave this much of a zero
constexpr double kZero_m = 1e-3;

struct SampleAt {
  int column = 0, row = 0;
  bool operator==(const SampleAt&) const = default;
};

constexpr std::array<SampleAt, 8> kNeighbours = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

struct SampleBlock {
  std::vector<SampleAt> cells;
  SampleAt first, last;  // corners of the box around the cells

  bool holds(SampleAt cell) const { return std::ranges::find(cells, cell) != cells.end(); }
  void add(SampleAt cell) {
    cells.push_back(cell);
    first = {std::min(first.column, cell.column), std::min(first.row, cell.row)};
    last = {std::max(last.column, cell.column), std::max(last.row, cell.row)};
  }
  // True if no other cell of the block comes before in the order of rows.
  bool begins_at(SampleAt start) const {
    return std::ranges::none_of(cells, [&](SampleAt cell) {
      return cell.row != start.row ? cell.row < start.row : cell.column < start.column;
    });
  }
  bool is_small() const { return last.column - first.column < kLargestBlock && last.row - first.row < kLargestBlock; }
};

bool is_inside(const Raster& raster, SampleAt cell) {
  return cell.column >= 0 && cell.row >= 0 && cell.column < raster.columns && cell.row < raster.rows;
}

double height_at_m(const Raster& raster, SampleAt cell) { return raster.at(cell.column, cell.row); }

double least_step_m(const Raster& raster) { return kLeastStep_m + kLeastStepSlope * raster.file_spacing_m; }

// ---- samples that belong together ----

// The samples to which one leads from neighbour to neighbour; nothing if they are no small block inside.
// @param is_one  True for two neighbouring samples that belong together.
template <typename IsOne>
std::optional<SampleBlock> block_from(const Raster& raster, SampleAt start, IsOne is_one) {
  SampleBlock block{{}, start, start};
  block.add(start);
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const SampleAt cell = block.cells[i];
    for (const SampleAt by : kNeighbours) {
      const SampleAt next{cell.column + by.column, cell.row + by.row};
      if (!is_inside(raster, next)) return std::nullopt;
      if (is_one(height_at_m(raster, cell), height_at_m(raster, next)) && !block.holds(next)) block.add(next);
    }
    if (!block.is_small()) return std::nullopt;
  }
  return block;
}

// True if all samples around the block are below it, or all above, except a few voids.
bool stands_alone(const Raster& raster, const SampleBlock& block) {
  int above = 0, below = 0, unknown = 0;
  for (const SampleAt cell : block.cells) {
    for (const SampleAt by : kNeighbours) {
      const SampleAt next{cell.column + by.column, cell.row + by.row};
      if (block.holds(next)) continue;
      const double rise_m = height_at_m(raster, cell) - height_at_m(raster, next);
      above += rise_m > 0, below += rise_m < 0, unknown += std::isnan(rise_m);
    }
  }
  const int known = above + below;
  return (above == 0 || below == 0) && known >= kKnownEdges * (known + unknown);
}

// ---- the land around ----

// The plane height = mean + east * (column - middle) + south * (row - middle).
struct LandPlane {
  double mean_m = 0, east_m = 0, south_m = 0, column = 0, row = 0;
  double height_m(SampleAt cell) const { return mean_m + east_m * (cell.column - column) + south_m * (cell.row - row); }
};

// How many samples a cell is away from a block, diagonally too.
int samples_away(const SampleBlock& block, SampleAt cell) {
  int away = std::numeric_limits<int>::max();
  for (const SampleAt own : block.cells)
    away = std::min(away, std::max(std::abs(own.column - cell.column), std::abs(own.row - cell.row)));
  return away;
}

// The known samples that are more than some samples, and at most others, away from the block.
std::vector<SampleAt> land_around(const Raster& raster, const SampleBlock& block, int more_than, int at_most) {
  std::vector<SampleAt> land;
  for (int row = block.first.row - at_most; row <= block.last.row + at_most; ++row) {
    for (int column = block.first.column - at_most; column <= block.last.column + at_most; ++column) {
      const SampleAt cell{column, row};
      if (!is_inside(raster, cell) || std::isnan(height_at_m(raster, cell))) continue;
      const int away = samples_away(block, cell);
      if (away > more_than && away <= at_most) land.push_back(cell);
    }
  }
  return land;
}

// The plane through the samples with the smallest sum of squares; level if they lie on one line.
LandPlane plane_through(const Raster& raster, const std::vector<SampleAt>& cells) {
  LandPlane plane;
  const double share = 1.0 / static_cast<double>(cells.size());
  for (const SampleAt cell : cells) {
    plane.column += share * cell.column, plane.row += share * cell.row;
    plane.mean_m += share * height_at_m(raster, cell);
  }
  double xx = 0, xy = 0, yy = 0, xh = 0, yh = 0;
  for (const SampleAt cell : cells) {
    const double x = cell.column - plane.column, y = cell.row - plane.row, h = height_at_m(raster, cell) - plane.mean_m;
    xx += x * x, xy += x * y, yy += y * y, xh += x * h, yh += y * h;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 0) return plane;
  plane.east_m = (xh * yy - yh * xy) / determinant, plane.south_m = (yh * xx - xh * xy) / determinant;
  return plane;
}

// The smallest and the largest distance of samples from a plane.
struct Distances {
  double least_m = std::numeric_limits<double>::infinity(), most_m = 0;
};

Distances distances_m(const Raster& raster, const std::vector<SampleAt>& cells, const LandPlane& plane) {
  Distances range;
  for (const SampleAt cell : cells) {
    const double away_m = std::abs(height_at_m(raster, cell) - plane.height_m(cell));
    range.least_m = std::min(range.least_m, away_m), range.most_m = std::max(range.most_m, away_m);
  }
  return range;
}

// ---- decision ----

struct Broken {
  SampleBlock block;
  double size_m = 0;
};

std::optional<Broken> broken_from(const Raster& raster, SampleAt start, double step_m) {
  // a void belongs to no block
  const auto is_one = [&](double a_m, double b_m) { return std::abs(a_m - b_m) <= step_m; };
  std::optional<SampleBlock> block = block_from(raster, start, is_one);
  if (!block || !block->begins_at(start) || !stands_alone(raster, *block)) return std::nullopt;
  const std::vector<SampleAt> land = land_around(raster, *block, 0, kLand);
  const LandPlane plane = plane_through(raster, land);
  const Distances own = distances_m(raster, block->cells, plane), around = distances_m(raster, land, plane);
  if (own.least_m <= step_m || own.most_m > kUneven * own.least_m || around.most_m > kRough * own.least_m)
    return std::nullopt;
  return Broken{std::move(*block), own.most_m};
}

bool is_zero(double height_m) { return std::abs(height_m) < kZero_m; }

// A block of zeros, with the samples beside it into which they are mixed.
std::optional<Broken> zeros_from(const Raster& raster, SampleAt start) {
  const auto is_one = [](double, double next_m) { return is_zero(next_m); };
  std::optional<SampleBlock> block = block_from(raster, start, is_one);
  if (!block || !block->begins_at(start)) return std::nullopt;
  const std::vector<SampleAt> land = land_around(raster, *block, kMixed, kMixed + kLand);
  if (land.empty()) return std::nullopt;
  const LandPlane plane = plane_through(raster, land);
  const Distances own = distances_m(raster, block->cells, plane), around = distances_m(raster, land, plane);
  if (own.least_m <= kLeastDepth_m + kLeastDepthSlope * raster.file_spacing_m || around.most_m > kRough * own.least_m)
    return std::nullopt;
  for (const SampleAt beside : land_around(raster, *block, 0, kMixed))
    if (std::abs(height_at_m(raster, beside) - plane.height_m(beside)) > around.most_m) block->add(beside);
  return Broken{std::move(*block), own.most_m};
}

// True for the first sample of each block in the order of rows, and for few others.
bool may_begin(const Raster& raster, SampleAt cell, double step_m) {
  const double own_m = height_at_m(raster, cell);
  if (std::isnan(own_m)) return false;
  const double west_m = own_m - raster.at(cell.column - 1, cell.row);
  const double north_m = own_m - raster.at(cell.column, cell.row - 1);
  return !(std::abs(west_m) <= step_m) && !(std::abs(north_m) <= step_m);
}

// True for the first sample of each block of zeros.
bool may_begin_zeros(const Raster& raster, SampleAt cell) {
  const auto is_zero_at = [&](int column, int row) { return is_zero(raster.at(column, row)); };
  return is_zero_at(cell.column, cell.row) && !is_zero_at(cell.column - 1, cell.row) &&
         !is_zero_at(cell.column, cell.row - 1);
}

// All blocks, in the order of their first samples.
std::vector<Broken> find_broken(const Raster& raster) {
  std::vector<Broken> found;
  const double step_m = least_step_m(raster);
  for (int row = 1; row < raster.rows; ++row) {
    for (int column = 1; column < raster.columns; ++column) {
      const SampleAt cell{column, row};
      std::optional<Broken> broken;
      if (may_begin(raster, cell, step_m)) broken = broken_from(raster, cell, step_m);
      if (!broken && may_begin_zeros(raster, cell)) broken = zeros_from(raster, cell);
      if (broken) found.push_back(std::move(*broken));
    }
  }
  return found;
}

}  // namespace

Raster blocks_to_voids(Raster raster, Report& report) {
  assert(raster.has_all_samples());
  // all are found before any is removed, so the result does not depend on the order
  for (const Broken& broken : find_broken(raster)) {
    for (const SampleAt cell : broken.block.cells)
      raster.heights_m[static_cast<std::size_t>(cell.row) * raster.columns + cell.column] = kVoid;
    report.add(Code::kHeightSpike, OsmId{}, broken.size_m);
  }
  return raster;
}

}  // namespace citykiln::source
