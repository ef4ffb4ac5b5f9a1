#include "compiler/source/join_rasters.h"

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

std::optional<Raster> joined(const Raster& a, const Raster& b) {
  if (is_empty(a) || is_empty(b)) return std::nullopt;
  const std::optional<Extent> of_b = extent_in(a, b);
  const Extent of_a{0, 0, a.columns, a.rows};
  if (!of_b || !fill_a_rectangle(of_a, *of_b)) return std::nullopt;
  const Extent whole = around(of_a, *of_b);
  Raster both{a.file_name,  a.credit, whole.east - whole.west,       whole.south - whole.north, {}, {},
              a.system_wkt, {},       around(a.file_box, b.file_box)};
  place_joined(a, b, *of_b, whole, both);
  both.heights_m.assign(static_cast<std::size_t>(both.columns) * both.rows, kVoid);
  copy_into(a, of_a, whole, both);
  copy_into(b, *of_b, whole, both);
  both.spacing_m = spacing_m_of(both);
  both.file_spacing_m = std::min(a.file_spacing_m, b.file_spacing_m);
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

std::vector<Raster> join_rasters(std::vector<Raster> rasters) {
  assert(std::ranges::all_of(rasters, &Raster::has_all_samples));
  for (std::size_t first = 0; first < rasters.size(); first = end_of_run(rasters, first)) {
    while (join_one(rasters, first, end_of_run(rasters, first))) {
    }
  }
  return rasters;
}

}  // namespace citykiln::source
