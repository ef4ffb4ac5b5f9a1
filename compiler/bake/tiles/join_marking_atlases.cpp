#include "compiler/bake/tiles/join_marking_atlases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "compiler/materials/material.h"

namespace citykiln::bake {
namespace {

using materials::TextureImage;

// Width of the gutter on each side of a seam; keeps neighbours apart down to the third mip level.
constexpr std::uint32_t kGutter_px = 4;

// Copies an atlas to columns first, first + 1, … of the joined one, repeating its rows to the full height.
void draw_markings(const TextureImage& sheet, std::int64_t first, TextureImage& joined) {
  const std::int64_t from = std::max<std::int64_t>(0, first - kGutter_px),
                     to = std::min<std::int64_t>(joined.columns, first + sheet.columns + kGutter_px);
  for (std::size_t row = 0; row < joined.rows; ++row)
    for (std::int64_t column = from; column < to; ++column) {
      const auto source = static_cast<std::size_t>(std::clamp<std::int64_t>(column - first, 0, sheet.columns - 1));
      joined.texels[row * joined.columns + static_cast<std::size_t>(column)] =
          sheet.texels[row % sheet.rows * sheet.columns + source];
    }
}

// The different atlases and their first columns.
struct Placed {
  std::vector<const TextureImage*> sheets;
  std::vector<std::int64_t> firsts;
  std::uint64_t columns = 0, rows = 1;

  std::int64_t place(const TextureImage& sheet) {
    const auto same = std::ranges::find_if(sheets, [&](const TextureImage* other) { return *other == sheet; });
    if (same != sheets.end()) return firsts[static_cast<std::size_t>(same - sheets.begin())];
    const std::uint64_t first = columns + (sheets.empty() ? 0 : 2 * kGutter_px);
    sheets.push_back(&sheet), firsts.push_back(static_cast<std::int64_t>(first));
    columns = first + sheet.columns;
    rows = std::min(std::lcm(rows, std::uint64_t{sheet.rows}), std::uint64_t{materials::kMaxImageSide_px} + 1);
    return firsts.back();
  }
};

double length_m(const TextureImage& sheet) { return sheet.texel_m * sheet.rows; }

// A texel's channels in linear light.
using Light = std::array<double, 3>;
TextureImage::Texel texel_of(const Light& light) {
  TextureImage::Texel texel{};
  for (std::size_t c = 0; c < 3; ++c) texel[c] = materials::srgb_of_linear(light[c]);
  return texel;
}

// The mean over a box inside the atlas, in texels.
TextureImage::Texel mean_of(const TextureImage& sheet, double left, double right, double low, double high) {
  Light sum{};
  double area = 0;
  for (auto row = static_cast<std::uint32_t>(low); row < high && row < sheet.rows; ++row)
    for (auto column = static_cast<std::uint32_t>(left); column < right && column < sheet.columns; ++column) {
      const double share = (std::min(high, row + 1.0) - std::max(low, static_cast<double>(row))) *
                           (std::min(right, column + 1.0) - std::max(left, static_cast<double>(column)));
      const TextureImage::Texel& texel = sheet.texels[std::size_t{row} * sheet.columns + column];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += share * materials::linear_of_srgb(texel[c]);
      area += share;
    }
  for (double& c : sum) c /= area;
  return texel_of(sum);
}

std::uint32_t columns_at(const TextureImage& sheet, std::uint32_t rows) {
  return static_cast<std::uint32_t>(std::ceil(static_cast<double>(sheet.columns) / sheet.rows * rows - 1e-9));
}

// The atlas resampled to the given number of rows.
TextureImage in_rows(const TextureImage& sheet, std::uint32_t rows) {
  if (sheet.rows == rows) return sheet;
  const double grown = static_cast<double>(sheet.rows) / rows;
  TextureImage coarse{length_m(sheet) / rows, columns_at(sheet, rows), rows, {}};
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < coarse.columns; ++column)
      coarse.texels.push_back(mean_of(sheet, std::min(column * grown, sheet.columns - 1e-6),
                                      std::min((column + 1) * grown, static_cast<double>(sheet.columns)), row * grown,
                                      (row + 1) * grown));
  return coarse;
}

// The number of rows of the coarsest atlas, or fewer if the joined one would be too wide.
std::uint32_t common_rows(std::span<const TextureImage* const> sheets) {
  std::uint32_t rows = materials::kMaxImageSide_px;
  for (const TextureImage* sheet : sheets)
    if (!sheet->texels.empty()) rows = std::min(rows, sheet->rows);
  const auto columns = [&] {
    std::uint64_t sum = 0;
    for (const TextureImage* sheet : sheets)
      if (!sheet->texels.empty()) sum += columns_at(*sheet, rows) + 2 * kGutter_px;
    return sum;
  };
  while (rows > 1 && (columns() > materials::kMaxImageSide_px || columns() * rows > materials::kMaxImageTexels))
    rows -= (rows + 15) / 16;
  return rows;
}

bool have_equal_layout(std::span<const TextureImage* const> sheets) {
  const TextureImage* first = nullptr;
  for (const TextureImage* sheet : sheets) {
    if (sheet->texels.empty()) continue;
    if (first && length_m(*sheet) != length_m(*first)) return false;
    first = sheet;
  }
  return true;
}

// Joins the atlases without resampling.
Result<JoinedMarkingAtlases> side_by_side(std::span<const TextureImage* const> sheets) {
  Placed placed;
  JoinedMarkingAtlases joined;
  for (const TextureImage* sheet : sheets) {
    const std::int64_t first = sheet->texels.empty() ? 0 : placed.place(*sheet);
    joined.offsets_m.push_back(static_cast<double>(first) * sheet->texel_m);
  }
  if (std::max(placed.columns, placed.rows) > materials::kMaxImageSide_px ||
      placed.columns * placed.rows > materials::kMaxImageTexels)
    return Error{
        "", fmt::format("the joined marking atlas would be too large ({} by {} texels); bake fewer tiles, or bake to a "
                        "folder",
                        placed.columns, placed.rows)};
  if (placed.sheets.empty()) return joined;
  joined.sheet.texel_m = placed.sheets.front()->texel_m;
  joined.sheet.columns = static_cast<std::uint32_t>(placed.columns);
  joined.sheet.rows = static_cast<std::uint32_t>(placed.rows);
  joined.sheet.texels.resize(placed.columns * placed.rows);
  for (std::size_t i = 0; i < placed.sheets.size(); ++i)
    draw_markings(*placed.sheets[i], placed.firsts[i], joined.sheet);
  return joined;
}

bool have_one_texel(std::span<const TextureImage* const> sheets) {
  double texel = 0;
  for (const TextureImage* sheet : sheets) {
    if (sheet->texels.empty()) continue;
    if (texel != 0 && sheet->texel_m != texel) return false;
    texel = sheet->texel_m;
  }
  return true;
}

}  // namespace

Result<JoinedMarkingAtlases> join_marking_atlases(std::span<const TextureImage* const> sheets) {
  assert(std::ranges::none_of(sheets, [](const TextureImage* sheet) { return sheet == nullptr; }));
  // equal atlases are stored once, so they may fit without resampling
  if (have_one_texel(sheets)) {
    Result<JoinedMarkingAtlases> joined = side_by_side(sheets);
    if (joined || !have_equal_layout(sheets)) return joined;
  }
  if (!have_equal_layout(sheets))
    return Error{"",
                 "the tiles' marking atlases have different lengths and do not fit into one file; bake to a folder"};
  const std::uint32_t rows = common_rows(sheets);
  std::vector<TextureImage> coarser;
  for (const TextureImage* sheet : sheets)
    coarser.push_back(sheet->texels.empty() ? TextureImage{} : in_rows(*sheet, rows));
  std::vector<const TextureImage*> pointers;
  for (const TextureImage& sheet : coarser) pointers.push_back(&sheet);
  return side_by_side(pointers);
}

}  // namespace citykiln::bake
