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
void draw_markings(const TextureImage& atlas, std::int64_t first, TextureImage& joined) {
  const std::int64_t from = std::max<std::int64_t>(0, first - kGutter_px),
                     to = std::min<std::int64_t>(joined.columns, first + atlas.columns + kGutter_px);
  for (std::size_t row = 0; row < joined.rows; ++row)
    for (std::int64_t column = from; column < to; ++column) {
      const auto source = static_cast<std::size_t>(std::clamp<std::int64_t>(column - first, 0, atlas.columns - 1));
      joined.texels[row * joined.columns + static_cast<std::size_t>(column)] =
          atlas.texels[row % atlas.rows * atlas.columns + source];
    }
}

// The different atlases and their first columns.
struct Placed {
  std::vector<const TextureImage*> atlases;
  std::vector<std::int64_t> firsts;
  std::uint64_t columns = 0, rows = 1;

  std::int64_t place(const TextureImage& atlas) {
    const auto same = std::ranges::find_if(atlases, [&](const TextureImage* other) { return *other == atlas; });
    if (same != atlases.end()) return firsts[static_cast<std::size_t>(same - atlases.begin())];
    const std::uint64_t first = columns + (atlases.empty() ? 0 : 2 * kGutter_px);
    atlases.push_back(&atlas), firsts.push_back(static_cast<std::int64_t>(first));
    columns = first + atlas.columns;
    rows = std::min(std::lcm(rows, std::uint64_t{atlas.rows}), std::uint64_t{materials::kMaxImageSide_px} + 1);
    return firsts.back();
  }
};

double length_m(const TextureImage& atlas) { return atlas.texel_m * atlas.rows; }

// A texel's channels in linear light.
using Light = std::array<double, 3>;
TextureImage::Texel texel_of(const Light& light) {
  TextureImage::Texel texel{};
  for (std::size_t c = 0; c < 3; ++c) texel[c] = materials::srgb_of_linear(light[c]);
  return texel;
}

// The mean over a box inside the atlas, in texels.
TextureImage::Texel mean_of(const TextureImage& atlas, double left, double right, double low, double high) {
  Light sum{};
  double area = 0;
  for (auto row = static_cast<std::uint32_t>(low); row < high && row < atlas.rows; ++row)
    for (auto column = static_cast<std::uint32_t>(left); column < right && column < atlas.columns; ++column) {
      const double share = (std::min(high, row + 1.0) - std::max(low, static_cast<double>(row))) *
                           (std::min(right, column + 1.0) - std::max(left, static_cast<double>(column)));
      const TextureImage::Texel& texel = atlas.texels[std::size_t{row} * atlas.columns + column];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += share * materials::linear_of_srgb(texel[c]);
      area += share;
    }
  for (double& c : sum) c /= area;
  return texel_of(sum);
}

std::uint32_t columns_at(const TextureImage& atlas, std::uint32_t rows) {
  return static_cast<std::uint32_t>(std::ceil(static_cast<double>(atlas.columns) / atlas.rows * rows - 1e-9));
}

// The atlas resampled to the given number of rows.
TextureImage in_rows(const TextureImage& atlas, std::uint32_t rows) {
  if (atlas.rows == rows) return atlas;
  const double grown = static_cast<double>(atlas.rows) / rows;
  TextureImage coarse{length_m(atlas) / rows, columns_at(atlas, rows), rows, {}};
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < coarse.columns; ++column)
      coarse.texels.push_back(mean_of(atlas, std::min(column * grown, atlas.columns - 1e-6),
                                      std::min((column + 1) * grown, static_cast<double>(atlas.columns)), row * grown,
                                      (row + 1) * grown));
  return coarse;
}

// The number of rows of the coarsest atlas, or fewer if the joined one would be too wide.
std::uint32_t common_rows(std::span<const TextureImage* const> atlases) {
  std::uint32_t rows = materials::kMaxImageSide_px;
  for (const TextureImage* atlas : atlases)
    if (!atlas->texels.empty()) rows = std::min(rows, atlas->rows);
  const auto columns = [&] {
    std::uint64_t sum = 0;
    for (const TextureImage* atlas : atlases)
      if (!atlas->texels.empty()) sum += columns_at(*atlas, rows) + 2 * kGutter_px;
    return sum;
  };
  while (rows > 1 && (columns() > materials::kMaxImageSide_px || columns() * rows > materials::kMaxImageTexels))
    rows -= (rows + 15) / 16;
  return rows;
}

bool have_equal_layout(std::span<const TextureImage* const> atlases) {
  const TextureImage* first = nullptr;
  for (const TextureImage* atlas : atlases) {
    if (atlas->texels.empty()) continue;
    if (first && length_m(*atlas) != length_m(*first)) return false;
    first = atlas;
  }
  return true;
}

// Joins the atlases without resampling.
Result<JoinedMarkingAtlases> side_by_side(std::span<const TextureImage* const> atlases) {
  Placed placed;
  JoinedMarkingAtlases joined;
  for (const TextureImage* atlas : atlases) {
    const std::int64_t first = atlas->texels.empty() ? 0 : placed.place(*atlas);
    joined.offsets_m.push_back(static_cast<double>(first) * atlas->texel_m);
  }
  if (std::max(placed.columns, placed.rows) > materials::kMaxImageSide_px ||
      placed.columns * placed.rows > materials::kMaxImageTexels)
    return Error{
        "", fmt::format("the joined marking atlas would be too large ({} by {} texels); bake fewer tiles, or bake to a "
                        "folder",
                        placed.columns, placed.rows)};
  if (placed.atlases.empty()) return joined;
  joined.image.texel_m = placed.atlases.front()->texel_m;
  joined.image.columns = static_cast<std::uint32_t>(placed.columns);
  joined.image.rows = static_cast<std::uint32_t>(placed.rows);
  joined.image.texels.resize(placed.columns * placed.rows);
  for (std::size_t i = 0; i < placed.atlases.size(); ++i)
    draw_markings(*placed.atlases[i], placed.firsts[i], joined.image);
  return joined;
}

bool have_one_texel(std::span<const TextureImage* const> atlases) {
  double texel = 0;
  for (const TextureImage* atlas : atlases) {
    if (atlas->texels.empty()) continue;
    if (texel != 0 && atlas->texel_m != texel) return false;
    texel = atlas->texel_m;
  }
  return true;
}

}  // namespace

Result<JoinedMarkingAtlases> join_marking_atlases(std::span<const TextureImage* const> atlases) {
  assert(std::ranges::none_of(atlases, [](const TextureImage* atlas) { return atlas == nullptr; }));
  // equal atlases are stored once, so they may fit without resampling
  if (have_one_texel(atlases)) {
    Result<JoinedMarkingAtlases> joined = side_by_side(atlases);
    if (joined || !have_equal_layout(atlases)) return joined;
  }
  if (!have_equal_layout(atlases))
    return Error{"",
                 "the tiles' marking atlases have different lengths and do not fit into one file; bake to a folder"};
  const std::uint32_t rows = common_rows(atlases);
  std::vector<TextureImage> coarser;
  for (const TextureImage* atlas : atlases)
    coarser.push_back(atlas->texels.empty() ? TextureImage{} : in_rows(*atlas, rows));
  std::vector<const TextureImage*> pointers;
  for (const TextureImage& atlas : coarser) pointers.push_back(&atlas);
  return side_by_side(pointers);
}

}  // namespace citykiln::bake
