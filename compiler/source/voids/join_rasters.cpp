#include "compiler/source/voids/join_rasters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/source/read_raster.h"

namespace citykiln::source {
namespace {

// in samples: far below what changes a height, far above what is lost when a file stores its origin in decimals
constexpr double kSamePlace = 1e-4;

/// Columns [west, east) and rows [north, south) of a grid.
struct Extent {
  int west = 0, north = 0, east = 0, south = 0;
  bool operator==(const Extent&) const = default;
};

Extent around(const Extent& a, const Extent& b) {
  return {std::min(a.west, b.west), std::min(a.north, b.north), std::max(a.east, b.east), std::max(a.south, b.south)};
}

LonLatBox around(const LonLatBox& a, const LonLatBox& b) {
  return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east), std::max(a.north, b.north)};
}

bool is_empty(const Raster& raster) { return raster.columns == 0 || raster.rows == 0; }

bool has_same_steps(const Raster& a, const Raster& b) {
  const auto& p = a.from_grid;
  const auto& q = b.from_grid;
  // steps must agree over all columns and rows of both
  const double samples = std::max({a.columns, a.rows, b.columns, b.rows});
  const double allowed = kSamePlace / samples * (std::abs(p[1]) + std::abs(p[5]));
  for (const int i : {1, 2, 4, 5}) {
    if (!(std::abs(p[i] - q[i]) <= allowed)) return false;
  }
  return true;
}

/// The extent of b in the grid of a. Empty if b's samples do not coincide with the grid.
std::optional<Extent> extent_in(const Raster& a, const Raster& b) {
  if (a.system_wkt != b.system_wkt || !has_same_steps(a, b)) return std::nullopt;
  const auto& g = a.from_grid;
  const double determinant = g[1] * g[5] - g[2] * g[4], x = b.from_grid[0] - g[0], y = b.from_grid[3] - g[3];
  const double column = (x * g[5] - y * g[2]) / determinant, row = (y * g[1] - x * g[4]) / determinant;
  const double c = std::round(column), r = std::round(row);
  const bool is_near = std::abs(c) < 1e8 && std::abs(r) < 1e8;
  if (!is_near || std::abs(column - c) > kSamePlace || std::abs(row - r) > kSamePlace) return std::nullopt;
  const int west = static_cast<int>(c), north = static_cast<int>(r);
  return Extent{west, north, west + b.columns, north + b.rows};
}

/// True if the two, side by side or one above the other, fill the rectangle around them.
bool fill_a_rectangle(const Extent& a, const Extent& b) {
  const bool is_beside = a.north == b.north && a.south == b.south && a.west <= b.east && b.west <= a.east;
  const bool is_above = a.west == b.west && a.east == b.east && a.north <= b.south && b.north <= a.south;
  const Extent both = around(a, b);
  return is_beside || is_above || both == a || both == b;
}

/// @param extent  The source's place in the grid of the joined raster's first input.
void copy_into(const Raster& source, const Extent& extent, const Extent& whole, Raster& joined) {
  for (int row = 0; row < source.rows; ++row) {
    for (int column = 0; column < source.columns; ++column) {
      const std::size_t at = static_cast<std::size_t>(extent.north - whole.north + row) * joined.columns +
                             (extent.west - whole.west + column);
      float& height_m = joined.heights_m[at];
      if (std::isnan(height_m)) height_m = source.at(column, row);
    }
  }
}

/// Sets the place of the north-western sample: copied from the part that begins there, which rounds nothing, else
/// computed.
void place_joined(const Raster& a, const Raster& b, const Extent& of_b, const Extent& whole, Raster& joined) {
  const bool is_a_first = whole.west == 0 && whole.north == 0;
  const bool is_b_first = whole.west == of_b.west && whole.north == of_b.north;
  joined.from_grid = is_a_first || !is_b_first ? a.from_grid : b.from_grid;
  if (is_a_first || is_b_first) return;
  const auto& g = a.from_grid;
  joined.from_grid[0] += g[1] * whole.west + g[2] * whole.north;
  joined.from_grid[3] += g[4] * whole.west + g[5] * whole.north;
}

/// The differences between two rasters where they meet, in metres that `a` is higher: of samples that both have, and of
/// heights extrapolated to the middle between their outermost samples, where one ends beside the other.
std::vector<double> differences_m(const Raster& a, const Raster& b, const Extent& of_b) {
  std::vector<double> found_m;
  const auto add = [&](double difference_m) {
    if (std::isfinite(difference_m)) found_m.push_back(difference_m);
  };
  const auto in_b = [&](int column, int row) { return double{b.at(column - of_b.west, row - of_b.north)}; };
  const int west = std::max(0, of_b.west), east = std::min(a.columns, of_b.east), north = std::max(0, of_b.north),
            south = std::min(a.rows, of_b.south);
  for (int row = north; row < south; ++row)
    for (int column = west; column < east; ++column) add(a.at(column, row) - in_b(column, row));
  const auto beyond = [](double last_m, double before_m) { return last_m + (last_m - before_m) / 2; };
  if (a.columns < 2 || a.rows < 2 || b.columns < 2 || b.rows < 2) return found_m;
  for (int row = north; row < south && (of_b.west == a.columns || of_b.east == 0); ++row) {
    const bool is_east = of_b.west == a.columns;
    const int own = is_east ? a.columns - 1 : 0, other = is_east ? of_b.west : -1, step = is_east ? 1 : -1;
    add(beyond(a.at(own, row), a.at(own - step, row)) - beyond(in_b(other, row), in_b(other + step, row)));
  }
  for (int column = west; column < east && (of_b.north == a.rows || of_b.south == 0); ++column) {
    const bool is_south = of_b.north == a.rows;
    const int own = is_south ? a.rows - 1 : 0, other = is_south ? of_b.north : -1, step = is_south ? 1 : -1;
    add(beyond(a.at(column, own), a.at(column, own - step)) - beyond(in_b(column, other), in_b(column, other + step)));
  }
  return found_m;
}

/// True if two rasters have different datums: their step is even, and larger than errors are.
bool has_step(const Raster& a, const Raster& b, const Extent& of_b) {
  const std::vector<double> found_m = differences_m(a, b, of_b);
  return step_of_m(found_m, a.file_spacing_m + b.file_spacing_m).has_value();
}

std::optional<Raster> joined(const Raster& a, const Raster& b) {
  if (is_empty(a) || is_empty(b)) return std::nullopt;
  const std::optional<Extent> of_b = extent_in(a, b);
  const Extent of_a{0, 0, a.columns, a.rows};
  if (!of_b || !fill_a_rectangle(of_a, *of_b) || a.is_fitted || b.is_fitted || has_step(a, b, *of_b))
    return std::nullopt;
  const Extent whole = around(of_a, *of_b);
  Raster both;
  both.file_name = a.file_name, both.credit = a.credit;
  both.columns = whole.east - whole.west, both.rows = whole.south - whole.north;
  both.system_wkt = a.system_wkt, both.file_box = around(a.file_box, b.file_box);
  place_joined(a, b, *of_b, whole, both);
  both.heights_m.assign(static_cast<std::size_t>(both.columns) * both.rows, kVoid);
  copy_into(a, of_a, whole, both);
  copy_into(b, *of_b, whole, both);
  both.spacing_m = spacing_m_of(both);
  both.file_spacing_m = std::min(a.file_spacing_m, b.file_spacing_m);
  both.code_heights_m = a.code_heights_m;
  both.code_heights_m.insert(both.code_heights_m.end(), b.code_heights_m.begin(), b.code_heights_m.end());
  return both;
}

/// Joins the first possible pair of the run [first, last); returns false if there is none.
bool join_one(std::vector<Raster>& rasters, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    for (std::size_t j = i + 1; j < last; ++j) {
      std::optional<Raster> both = joined(rasters[i], rasters[j]);
      if (!both) continue;
      rasters[i] = std::move(*both);
      rasters.erase(rasters.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

/// The end of the run of rasters from `first` on that share its grid. Rasters separated by another grid stay separate.
std::size_t end_of_run(const std::vector<Raster>& rasters, std::size_t first) {
  std::size_t last = first + 1;
  const auto is_on_grid = [&](const Raster& raster) {
    return is_empty(raster) || is_empty(rasters[first]) || extent_in(rasters[first], raster);
  };
  while (last < rasters.size() && is_on_grid(rasters[last])) ++last;
  return last;
}

}  // namespace

std::optional<double> step_of_m(std::span<const double> differences_m, double spacings_m) {
  constexpr std::size_t kFewest = 8;
  constexpr double kLeast_m = 2, kLeastSlope = 0.1, kEven = 2;
  const double count = static_cast<double>(differences_m.size());
  if (differences_m.size() < kFewest) return std::nullopt;
  double mean_m = 0, square_m2 = 0;
  for (const double difference_m : differences_m) mean_m += difference_m / count;
  for (const double difference_m : differences_m)
    square_m2 += (difference_m - mean_m) * (difference_m - mean_m) / count;
  const bool is_clear = std::abs(mean_m) > std::max(kLeast_m + kLeastSlope * spacings_m, kEven * std::sqrt(square_m2));
  return is_clear ? std::optional(mean_m) : std::nullopt;
}

std::vector<Raster> join_rasters(std::vector<Raster> rasters) {
  assert(std::ranges::all_of(rasters, &Raster::has_all_samples));
  for (std::size_t first = 0; first < rasters.size(); first = end_of_run(rasters, first)) {
    while (join_one(rasters, first, end_of_run(rasters, first))) {
    }
  }
  return rasters;
}

}  // namespace citykiln::source
