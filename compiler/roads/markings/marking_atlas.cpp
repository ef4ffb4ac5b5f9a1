#include "compiler/roads/markings/marking_atlas.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/materials/paint.h"
#include "compiler/roads/markings/drainage.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/markings/wear.h"

namespace citykiln::roads {
namespace {

using materials::ColumnRange;
using materials::TextureImage;

// The number of texels along the layout's length, which fixes their size.
std::uint32_t rows_of(double texel_m) {
  // rounding must not cost a row where the texel divides the length
  return static_cast<std::uint32_t>(std::max(1.0, std::floor(kLayoutLength_m / texel_m + 1e-6)));
}

std::uint64_t columns_of(const MarkingLayout& layout, double texel_m) {
  const double columns = std::ceil(width_m(layout) / texel_m - 1e-6);
  return 2 * kGutter_texels + static_cast<std::uint64_t>(std::clamp<double>(columns, 1, 2 * kWidest_texels));
}

// The number of layouts, from the first, that fit side by side.
std::size_t fitting(std::span<const MarkingLayout> layouts, std::uint32_t rows) {
  std::uint64_t columns = 0;
  std::size_t count = 0;
  while (count < layouts.size() && (columns += columns_of(layouts[count], kLayoutLength_m / rows)) <= kWidest_texels)
    ++count;
  return count;
}

std::uint32_t finest_rows(std::span<const MarkingLayout> layouts, double tolerance_m) {
  std::uint32_t rows = rows_of(std::max(tolerance_m, kFinestTexel_m));
  const std::uint32_t coarsest = std::min(rows, rows_of(kCoarsestTexel_m));
  while (rows > coarsest && fitting(layouts, rows) < layouts.size()) --rows;
  return rows;
}

// Fills the gutters with the outermost texels. A last texel that the strip covers partly counts as gutter.
void repeat_outermost(TextureImage& sheet, ColumnRange columns, std::uint32_t whole_columns) {
  const std::uint32_t end = columns.first + std::max(1u, whole_columns);
  for (std::size_t row = 0; row < sheet.rows; ++row) {
    TextureImage::Texel* texels = &sheet.texels[row * sheet.columns];
    std::fill_n(texels + columns.first - kGutter_texels, kGutter_texels, texels[columns.first]);
    std::fill(texels + end, texels + columns.end + kGutter_texels, texels[end - 1]);
  }
}

void draw(const MarkingLayout& layout, ColumnRange columns, TextureImage& sheet) {
  const double left_m = columns.first * sheet.texel_m;
  const auto paint = [&](Ring ring, TextureImage::Texel colour) {
    for (Vec2& p : ring) p.x += left_m;
    materials::paint(sheet, columns, ring, colour);
  };
  paint(rectangle({0, 0}, {(columns.end - columns.first) * sheet.texel_m, kLayoutLength_m}), base_colour_of(layout));
  for (const Marks& marks : {wear_of(layout), marks_of(layout), drainage_of(layout)})
    for (const Mark& mark : marks) paint(mark.ring, mark.colour);
  repeat_outermost(sheet, columns, static_cast<std::uint32_t>(width_m(layout) / sheet.texel_m + 1e-6));
}

}  // namespace

MarkingAtlas make_marking_atlas(std::span<const MarkingLayout> layouts, double tolerance_m) {
  assert(std::ranges::is_sorted(layouts) && std::ranges::adjacent_find(layouts) == layouts.end());
  assert(tolerance_m >= 0);
  if (layouts.empty()) return {};
  MarkingAtlas atlas;
  atlas.left_m.assign(layouts.size(), kNoColumn_m);
  const std::uint32_t rows = finest_rows(layouts, tolerance_m);
  const double texel_m = kLayoutLength_m / rows;

  std::vector<ColumnRange> ranges;
  std::uint32_t columns = 0;
  for (const MarkingLayout& layout : layouts.first(fitting(layouts, rows))) {
    const auto width = static_cast<std::uint32_t>(columns_of(layout, texel_m));
    ranges.push_back({columns + kGutter_texels, columns + width - kGutter_texels});
    atlas.left_m[ranges.size() - 1] = ranges.back().first * texel_m;
    columns += width;
  }
  if (ranges.empty()) return atlas;
  atlas.image = materials::blank_image(texel_m, columns, rows, {});
  for (std::size_t i = 0; i < ranges.size(); ++i) draw(layouts[i], ranges[i], atlas.image);
  return atlas;
}

}  // namespace citykiln::roads
