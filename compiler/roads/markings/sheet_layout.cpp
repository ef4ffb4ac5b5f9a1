#include "compiler/roads/markings/sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "compiler/materials/paint.h"
#include "compiler/roads/markings/markings.h"

namespace citykiln::roads {
namespace {

using materials::ColumnRange;
using materials::Sheet;

// Texels along the sheet: what decides how large they are.
std::uint32_t rows_of(double texel_m) {
  // a texel that divides the pattern but for rounding is meant to divide it
  return static_cast<std::uint32_t>(std::max(1.0, std::floor(kPatternLength_m / texel_m + 1e-6)));
}

std::uint64_t columns_of(const Pattern& pattern, double texel_m) {
  const double columns = std::ceil(width_m(pattern) / texel_m - 1e-6);
  return 2 * kGutter_texels + static_cast<std::uint64_t>(std::clamp<double>(columns, 1, 2 * kMostColumns));
}

// How many of the patterns, from the first, fit.
std::size_t fitting(std::span<const Pattern> patterns, std::uint32_t rows) {
  std::uint64_t columns = 0;
  std::size_t count = 0;
  while (count < patterns.size() && (columns += columns_of(patterns[count], kPatternLength_m / rows)) <= kMostColumns)
    ++count;
  return count;
}

std::uint32_t finest_rows(std::span<const Pattern> patterns, double tolerance_m) {
  std::uint32_t rows = rows_of(std::max(tolerance_m, kFinestTexel_m));
  const std::uint32_t coarsest = std::min(rows, rows_of(kCoarsestTexel_m));
  while (rows > coarsest && fitting(patterns, rows) < patterns.size()) --rows;
  return rows;
}

// A last texel that the strip covers in part only counts as gutter.
void repeat_outermost(Sheet& sheet, ColumnRange columns, std::uint32_t whole_columns) {
  const std::uint32_t end = columns.first + std::max(1u, whole_columns);
  for (std::size_t row = 0; row < sheet.rows; ++row) {
    Sheet::Texel* texels = &sheet.texels[row * sheet.columns];
    std::fill_n(texels + columns.first - kGutter_texels, kGutter_texels, texels[columns.first]);
    std::fill(texels + end, texels + columns.end + kGutter_texels, texels[end - 1]);
  }
}

void draw(const Pattern& pattern, ColumnRange columns, Sheet& sheet) {
  const double left_m = columns.first * sheet.texel_m;
  const auto paint = [&](Ring ring, Sheet::Texel colour) {
    for (Vec2& p : ring) p.x += left_m;
    materials::paint(sheet, columns, ring, colour);
  };
  paint(rectangle({0, 0}, {(columns.end - columns.first) * sheet.texel_m, kPatternLength_m}), base_colour_of(pattern));
  for (const Mark& mark : marks_of(pattern)) paint(mark.ring, mark.colour);
  repeat_outermost(sheet, columns, static_cast<std::uint32_t>(width_m(pattern) / sheet.texel_m + 1e-6));
}

}  // namespace

SheetLayout lay_out(std::span<const Pattern> patterns, double tolerance_m) {
  if (patterns.empty()) return {};
  SheetLayout layout;
  layout.left_m.assign(patterns.size(), kNoColumn_m);
  const std::uint32_t rows = finest_rows(patterns, tolerance_m);
  const double texel_m = kPatternLength_m / rows;

  std::vector<ColumnRange> ranges;
  std::uint32_t columns = 0;
  for (const Pattern& pattern : patterns.first(fitting(patterns, rows))) {
    const auto width = static_cast<std::uint32_t>(columns_of(pattern, texel_m));
    ranges.push_back({columns + kGutter_texels, columns + width - kGutter_texels});
    layout.left_m[ranges.size() - 1] = ranges.back().first * texel_m;
    columns += width;
  }
  if (ranges.empty()) return layout;
  layout.sheet = materials::blank_sheet(texel_m, columns, rows, {});
  for (std::size_t i = 0; i < ranges.size(); ++i) draw(patterns[i], ranges[i], layout.sheet);
  return layout;
}

}  // namespace citykiln::roads
