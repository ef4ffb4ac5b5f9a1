#include "compiler/commands/atlas_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

#include "compiler/commands/sheet.h"
#include "compiler/geometry/box.h"
#include "compiler/outputs/run_report.h"
#include "exporters/gltf/glb.h"

namespace citykiln::commands {
namespace {

using materials::TextureImage;

constexpr int kSheetWidth_px = 1920, kGap_px = 16, kMostShown_px = 400;
// Reflectances as radiances of which write_image() shows white as a wall in the sun.
constexpr float kShownAsLight = 3;

// The corners of a primitive's faces that belong together, by the number of a vertex of each.
std::vector<std::uint32_t> joined_vertices(const bake::Primitive& primitive) {
  std::vector<std::uint32_t> parents(primitive.positions.size());
  std::iota(parents.begin(), parents.end(), 0u);
  const auto root = [&](std::uint32_t vertex) {
    while (parents[vertex] != vertex) vertex = parents[vertex] = parents[parents[vertex]];
    return vertex;
  };
  for (const auto& [a, b, c] : primitive.triangles) parents[root(a)] = root(b), parents[root(b)] = root(c);
  for (std::uint32_t vertex = 0; vertex < parents.size(); ++vertex) parents[vertex] = root(vertex);
  return parents;
}

// The rectangles of an atlas that a primitive shows, in metres.
std::vector<Box2> rectangles_of(const bake::Primitive& primitive) {
  const std::vector<std::uint32_t> joined = joined_vertices(primitive);
  std::vector<Box2> boxes(primitive.positions.size());
  for (std::size_t i = 0; i < joined.size(); ++i) boxes[joined[i]].grow(bake::widened(primitive.uvs[i]));
  std::erase_if(boxes, [](const Box2& box) { return box.is_empty(); });
  return boxes;
}

// The part of an image that a rectangle covers.
TextureImage part_of(const TextureImage& image, const Box2& box) {
  const auto texel = [&](double at_m, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(std::round(at_m / image.texel_m), 0.0, static_cast<double>(most)));
  };
  const std::uint32_t left = texel(box.min.x, image.columns), right = texel(box.max.x, image.columns),
                      top = texel(box.min.y, image.rows), bottom = texel(box.max.y, image.rows);
  TextureImage part{image.texel_m, right - left, bottom - top, {}};
  for (std::uint32_t row = top; row < bottom; ++row)
    for (std::uint32_t column = left; column < right; ++column)
      part.texels.push_back(image.texels[static_cast<std::size_t>(row) * image.columns + column]);
  return part;
}

// Adds the pictures of a tile that are not there yet.
void add_pictures_of(const bake::BakedTile& tile, std::set<std::vector<TextureImage::Texel>>& known,
                     std::vector<TextureImage>& pictures) {
  const TextureImage& atlas = tile.facade_atlas.colour;
  if (atlas.texels.empty()) return;
  for (const bake::Primitive& primitive : tile.primitives)
    if (primitive.colour_source == materials::ColourSource::kByAtlas)
      for (const Box2& box : rectangles_of(primitive))
        if (TextureImage part = part_of(atlas, box); !part.texels.empty() && known.insert(part.texels).second)
          pictures.push_back(std::move(part));
}

Result<std::vector<std::string>> tiles_in(const std::string& input) {
  if (input.ends_with(".glb")) return std::vector{input};
  const Result<outputs::RunRecord> record = outputs::read_report(input);
  if (!record) return record.error();
  std::vector<std::string> paths;
  for (const outputs::WrittenTile& tile : record->tiles)
    if (tile.level == 0) paths.push_back(input + "/" + tile.file.name);
  return paths;
}

// A picture as it is shown: large ones are halved until they fit.
preview::Image shown_picture(const TextureImage& picture) {
  std::uint32_t step = 1;
  while (std::max(picture.columns, picture.rows) / step > kMostShown_px) step *= 2;
  preview::Image image = empty_sheet(static_cast<int>(picture.columns / step), static_cast<int>(picture.rows / step));
  std::size_t i = 0;
  for (std::uint32_t row = 0; row + step <= picture.rows; row += step)
    for (std::uint32_t column = 0; column + step <= picture.columns; column += step)
      for (const std::uint8_t value : picture.texels[static_cast<std::size_t>(row) * picture.columns + column])
        if (i < image.rgb.size()) image.rgb[i++] = kShownAsLight * materials::linear_of_srgb(value);
  return image;
}

// A picture's place on the sheet.
struct SheetPlace {
  preview::Image image;
  std::string text;
  int x = 0, y = 0;
};

// Places pictures in rows from the left. Returns the height of the sheet.
int lay_out(std::vector<SheetPlace>& places) {
  int x = kGap_px, y = kGap_px, row_px = 0;
  for (SheetPlace& place : places) {
    const int width = std::max(place.image.width, static_cast<int>(place.text.size()) * kLetterWidth_px);
    if (x + width + kGap_px > kSheetWidth_px) x = kGap_px, y += row_px, row_px = 0;
    place.x = x, place.y = y;
    x += width + kGap_px, row_px = std::max(row_px, place.image.height + kTextHeight_px + 2 * kGap_px);
  }
  return y + row_px;
}

}  // namespace

Result<Done> draw_atlas_sheet(const std::string& input, const std::string& path, const Console& console) {
  const Result<std::vector<std::string>> tiles = tiles_in(input);
  if (!tiles) return tiles.error();
  std::set<std::vector<TextureImage::Texel>> known;
  std::vector<TextureImage> pictures;
  for (const std::string& name : *tiles) {
    const Result<bake::BakedTile> tile = exporters::read_glb(name);
    if (!tile) return tile.error();
    add_pictures_of(*tile, known, pictures);
  }
  if (pictures.empty()) return Error{input, "has no facade atlas at level 0"};
  std::ranges::stable_sort(pictures, std::greater{}, &TextureImage::rows);
  std::vector<SheetPlace> places;
  for (const TextureImage& picture : pictures)
    places.push_back({shown_picture(picture), fmt::format("{:.1f} x {:.1f}", picture.columns * picture.texel_m,
                                                          picture.rows * picture.texel_m)});
  preview::Image sheet = empty_sheet(kSheetWidth_px, lay_out(places));
  for (const SheetPlace& place : places) {
    put_picture(place.image, place.x, place.y, sheet);
    put_text(place.text, place.x, place.y + place.image.height + 2, sheet);
  }
  console.print_line(fmt::format("{} pictures of {} tiles", pictures.size(), tiles->size()));
  return preview::write_image(sheet, path);
}

}  // namespace citykiln::commands
