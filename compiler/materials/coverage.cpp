// Each edge adds to every texel it crosses the signed area between itself and the texel's right side, and to the next
// texel the rest of its height in that row. The running sum along a row is then the covered share.
#include "compiler/materials/coverage.h"

#include <algorithm>
#include <cmath>

namespace citykiln::materials {
namespace {

constexpr double kFarthest_texels = 1 << 30;  // whole numbers of this size fit an int64 and a double with room to spare

struct Extent {
  double low, high;
};

Extent rows_of(const Ring& ring) {
  Extent extent{ring.front().y, ring.front().y};
  for (const Vec2& p : ring) extent = {std::min(extent.low, p.y), std::max(extent.high, p.y)};
  return extent;
}

Ring in_texels(const Ring& ring_m, double texel_m) {
  Ring ring;
  ring.reserve(ring_m.size());
  for (const Vec2& p : ring_m) {
    if (!(std::abs(p.x / texel_m) < kFarthest_texels && std::abs(p.y / texel_m) < kFarthest_texels)) return {};
    ring.push_back({p.x / texel_m, p.y / texel_m});
  }
  return ring;
}

// The part with side * x >= side * at (Sutherland, Hodgman 1974). If it falls into pieces, the edges that connect them
// cancel out in signed areas.
Ring clipped(const Ring& ring, double at, double side) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const bool a_in = side * a.x >= side * at, b_in = side * b.x >= side * at;
    if (a_in) kept.push_back(a);
    if (a_in != b_in) kept.push_back({at, a.y + (b.y - a.y) * ((at - a.x) / (b.x - a.x))});
  }
  return kept;
}

// Signed areas by texel, before the running sums.
struct Accumulator {
  double first_column, first_row;
  std::uint32_t columns, rows;  // with two more columns than the window, see coverage_of()
  std::vector<double> area;

  double* row(double at) {
    const auto offset = static_cast<std::int64_t>(at - first_row) % rows;
    return &area[static_cast<std::size_t>(offset) * columns];
  }
};

// Adds an edge that lies within one row.
void add_in_row(Vec2 a, Vec2 b, double* areas, Accumulator& sum) {
  const double step = b.x >= a.x ? 1 : -1;
  const double slope = b.x == a.x ? 0 : (b.y - a.y) / (b.x - a.x);
  const double last = std::floor(std::max(a.x, b.x)), first = std::floor(std::min(a.x, b.x));
  for (double column = first; column <= last; ++column) {
    const double low = std::max(column, std::min(a.x, b.x)), high = std::min(column + 1, std::max(a.x, b.x));
    const double height = a.x == b.x ? b.y - a.y : slope * (high - low) * step;
    const double right = column + 1 - (low + high) / 2;
    const auto at = static_cast<std::size_t>(column - sum.first_column);
    areas[at] += height * right;
    areas[at + 1] += height * (1 - right);
  }
}

void add_edge(Vec2 a, Vec2 b, Accumulator& sum) {
  if (a.y == b.y) return;
  const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
  // rounding must not carry a point out of the window
  const auto at = [&](double y) {
    const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    return y == b.y ? b : Vec2{std::clamp(x, std::min(a.x, b.x), std::max(a.x, b.x)), y};
  };
  for (double row = std::floor(low); row < high; ++row) {
    const Vec2 p = at(std::max(low, row)), q = at(std::min(high, row + 1));
    add_in_row(a.y < b.y ? p : q, a.y < b.y ? q : p, sum.row(row), sum);
  }
}

Coverage summed(const Accumulator& sum, std::uint32_t first_row, ColumnRange columns) {
  Coverage cover{columns.first, columns.end - columns.first, first_row, sum.rows, {}};
  cover.share.reserve(static_cast<std::size_t>(cover.rows) * cover.columns);
  for (std::size_t row = 0; row < sum.rows; ++row) {
    double run = 0;
    for (std::size_t column = 0; column < cover.columns; ++column) {
      run += sum.area[row * sum.columns + column];
      cover.share.push_back(std::min(1.0, std::abs(run)));
    }
  }
  return cover;
}

ColumnRange columns_under(const Ring& ring, ColumnRange columns) {
  double low = ring.front().x, high = low;
  for (const Vec2& p : ring) low = std::min(low, p.x), high = std::max(high, p.x);
  const auto first = static_cast<std::uint32_t>(std::floor(low));
  return {first, std::min(columns.end, static_cast<std::uint32_t>(std::floor(high)) + 1)};
}

}  // namespace

Coverage coverage_of(const Ring& ring_m, double texel_m, std::uint32_t rows, ColumnRange columns) {
  if (columns.first >= columns.end || rows == 0 || !(texel_m > 0)) return {};
  Ring ring = clipped(in_texels(ring_m, texel_m), columns.first, 1);
  ring = clipped(ring, columns.end, -1);
  if (ring.size() < 3) return {};

  const Extent extent = rows_of(ring);
  columns = columns_under(ring, columns);
  if (columns.first >= columns.end) return {};
  const double first_row = std::floor(extent.low);
  const auto rows_touched = static_cast<std::uint32_t>(std::min<double>(rows, std::ceil(extent.high) - first_row));
  if (rows_touched == 0) return {};

  // an edge on the window's right side writes into one column beyond it, and into the next
  Accumulator sum{static_cast<double>(columns.first), first_row, columns.end - columns.first + 2, rows_touched, {}};
  sum.area.assign(static_cast<std::size_t>(sum.rows) * sum.columns, 0);
  for (std::size_t i = 0; i < ring.size(); ++i) add_edge(ring[i], ring[(i + 1) % ring.size()], sum);
  const double wrapped_row = first_row - std::floor(first_row / rows) * rows;
  return summed(sum, static_cast<std::uint32_t>(wrapped_row), columns);
}

}  // namespace citykiln::materials
