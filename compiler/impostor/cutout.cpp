#include "compiler/impostor/cutout.h"

#include <algorithm>
#include <cassert>

#include "compiler/impostor/atlas.h"
#include "compiler/impostor/pack_boxes.h"
#include "compiler/materials/paint.h"

namespace citykiln::impostor {
namespace {

using materials::TextureImage;

// The cell of a picture, with a texel or more on each side of it.
BoxSize cell_of(const Picture& picture) {
  const auto padded = [&](std::uint32_t side) {
    const auto up = [&](std::uint32_t texels) { return (texels + 2 + side - 1) / side * side; };
    return BoxSize{up(picture.columns), up(picture.rows)};
  };
  BoxSize cell = padded(kCell_px);
  for (std::uint32_t side = 2 * kCell_px; side <= kWideCell_px; side *= 2) {
    const BoxSize wide = padded(side);
    if (wide.columns * wide.rows <= cell.columns * cell.rows) cell = wide;
  }
  return cell;
}

std::vector<BoxSize> cells_of(const std::vector<Picture>& pictures) {
  std::vector<BoxSize> cells;
  for (const Picture& picture : pictures) cells.push_back(cell_of(picture));
  return cells;
}

PackedBoxes packed_within_budget(std::vector<Picture>& pictures, double& texel_m) {
  PackedBoxes packed = pack_boxes(cells_of(pictures));
  const auto is_single = [](const Picture& p) { return p.columns == 1 && p.rows == 1; };
  while (std::uint64_t{packed.columns} * packed.rows > kMaxAtlasTexels && !std::ranges::all_of(pictures, is_single)) {
    for (Picture& picture : pictures) picture = halved(picture);
    texel_m *= 2;
    packed = pack_boxes(cells_of(pictures));
  }
  return packed;
}

// A cell, with the place of its picture in it.
struct Cell {
  BoxPlace at;
  BoxSize size;
  std::uint32_t left = 0, top = 0;
};

Cell cell_at(BoxPlace at, const Picture& picture) {
  const BoxSize size = cell_of(picture);
  return {at, size, (size.columns - picture.columns) / 2, (size.rows - picture.rows) / 2};
}

void draw_colours(const Picture& picture, const Cell& cell, TextureImage& image) {
  const TextureImage::Texel all = srgb_of(mean(picture).light);
  for (std::uint32_t y = 0; y < cell.size.rows; ++y)
    for (std::uint32_t x = 0; x < cell.size.columns; ++x) {
      const std::uint32_t column = x - cell.left, row = y - cell.top;  // wraps around to large values
      const bool is_inside = column < picture.columns && row < picture.rows;
      const Texel texel = is_inside ? picture.texels[std::size_t{row} * picture.columns + column] : Texel{};
      image.texels[std::size_t{cell.at.row + y} * image.columns + cell.at.column + x] =
          texel.shown > 0 ? srgb_of(texel.light) : all;
    }
}

CoverageGrid coverage_of(const Picture& picture, const Cell& cell) {
  const bool is_full = std::ranges::all_of(picture.texels, [](const Texel& t) { return t.shown == kSamplesPerTexel; });
  CoverageGrid grid{cell.size.columns, cell.size.rows,
                    std::vector<float>(std::size_t{cell.size.columns} * cell.size.rows, is_full ? 1.0f : 0.0f)};
  for (std::size_t row = 0; row < picture.rows; ++row)
    for (std::size_t column = 0; column < picture.columns; ++column)
      grid.share[(cell.top + row) * grid.columns + cell.left + column] =
          static_cast<float>(picture.texels[row * picture.columns + column].shown) / kSamplesPerTexel;
  return grid;
}

void draw_opacity(const Picture& picture, const Cell& cell, Cutout& cutout) {
  const std::vector<std::uint8_t> opacity = mip_opacity(coverage_of(picture, cell));
  for (std::size_t row = 0; row < cell.size.rows; ++row)
    std::ranges::copy_n(opacity.begin() + static_cast<std::ptrdiff_t>(row * cell.size.columns), cell.size.columns,
                        cutout.opacity.begin() +
                            static_cast<std::ptrdiff_t>((cell.at.row + row) * cutout.colour.columns + cell.at.column));
}

}  // namespace

CutoutLayout lay_out_cutout(std::vector<Picture> pictures, double texel_m) {
  assert(texel_m > 0 && std::ranges::none_of(pictures, [](const Picture& p) { return p.texels.empty(); }));
  if (pictures.empty()) return {};
  const PackedBoxes packed = packed_within_budget(pictures, texel_m);
  const TextureImage::Texel unused = srgb_of(mean(pictures.front()).light);
  CutoutLayout out{{materials::blank_image(texel_m, packed.columns, packed.rows, unused), {}, {}}, {}};
  // what is left over takes part in the coarsest levels: it must not draw pictures beside it below the cutoff
  out.cutout.opacity.resize(out.cutout.colour.texels.size(), kAlphaCutoff - 1);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Cell cell = cell_at(packed.places[i], pictures[i]);
    draw_colours(pictures[i], cell, out.cutout.colour);
    draw_opacity(pictures[i], cell, out.cutout);
    out.at_m.push_back(Vec2{double(cell.at.column + cell.left), double(cell.at.row + cell.top)} * texel_m);
  }
  return out;
}

}  // namespace citykiln::impostor
