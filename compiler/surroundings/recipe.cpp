#include "compiler/surroundings/recipe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace citykiln::surroundings {
namespace {

bool are_lines(const std::vector<std::int32_t>& lines) {
  const auto strictly = [](std::int32_t a, std::int32_t b) { return a >= b; };
  return lines.size() >= 2 && lines.size() <= kMostLines && lines.front() >= -kFarthest_m &&
         lines.back() <= kFarthest_m && std::ranges::adjacent_find(lines, strictly) == lines.end();
}

bool is_error(double error_m) { return error_m >= 0 && error_m <= 2 * kHighest_m; }

// A line and the share of the way to the next one.
struct Between {
  std::size_t line;
  double share;
};

Between between(const std::vector<std::int32_t>& lines, double value) {
  const auto after = std::ranges::upper_bound(lines, value, {}, [](std::int32_t v) { return static_cast<double>(v); });
  const auto line =
      std::clamp<std::ptrdiff_t>(after - lines.begin() - 1, 0, static_cast<std::ptrdiff_t>(lines.size()) - 2);
  const auto low = static_cast<std::size_t>(line);
  const double width = lines[low + 1] - lines[low];
  return {low, std::clamp((value - lines[low]) / width, 0.0, 1.0)};
}

}  // namespace

bool is_sound(const Surroundings& around) {
  if (around.x_m.empty() && around.y_m.empty()) return around == Surroundings{};
  const std::size_t count = around.columns() * around.rows();
  return are_lines(around.x_m) && are_lines(around.y_m) && around.heights_m.size() == count &&
         around.covers.size() == count && is_error(around.error_m) && is_error(around.rms_error_m) &&
         std::ranges::all_of(around.heights_m, [](std::int32_t h) { return h >= -kHighest_m && h <= kHighest_m; }) &&
         std::ranges::all_of(around.covers, [](Cover cover) { return cover < Cover::kCount; });
}

double height_m_at(const Surroundings& around, Vec2 place) {
  assert(!around.is_empty());
  const auto [i, u] = between(around.x_m, place.x);
  const auto [j, v] = between(around.y_m, place.y);
  const auto at = [&](std::size_t column, std::size_t row) {
    return static_cast<double>(around.heights_m[around.index(column, row)]);
  };
  const double south_west = at(i, j), north_east = at(i + 1, j + 1);
  if (u >= v) return south_west + (at(i + 1, j) - south_west) * u + (north_east - at(i + 1, j)) * v;
  return south_west + (at(i, j + 1) - south_west) * v + (north_east - at(i, j + 1)) * u;
}

Cover cover_at(const Surroundings& around, Vec2 place) {
  assert(!around.is_empty());
  const auto nearest = [](const Between& at) { return at.line + (at.share > 0.5 ? 1 : 0); };
  return around.covers[around.index(nearest(between(around.x_m, place.x)), nearest(between(around.y_m, place.y)))];
}

}  // namespace citykiln::surroundings
