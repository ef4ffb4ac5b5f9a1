#include "compiler/impostor/atlas.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>

#include "compiler/materials/paint.h"

namespace citykiln::impostor {
namespace {

using materials::TextureImage;

struct Place {
  std::uint32_t column = 0, row = 0;  // of the frame
};

// Where the frame of each picture begins, and the size of the atlas.
struct Shelves {
  std::vector<Place> places;
  std::uint32_t columns = 0, rows = 0;
};

// The size of a frame: one texel on each side, and one more to make it even.
std::uint32_t framed(std::uint32_t texels) { return (texels + 3) / 2 * 2; }

std::uint64_t area_of(std::span<const SharedPicture> pictures) {
  std::uint64_t area = 0;
  for (const SharedPicture& p : pictures) area += std::uint64_t{framed(p->columns)} * framed(p->rows);
  return area;
}

// An even width of at least the widest frame, so that the atlas is approximately square.
std::uint32_t width_of(std::span<const SharedPicture> pictures) {
  std::uint32_t widest = 2;
  for (const SharedPicture& p : pictures) widest = std::max(widest, framed(p->columns));
  const auto square = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(area_of(pictures))));
  return std::max(widest, (square + 3) / 4 * 4);
}

// Pictures of equal height stay in their order.
Shelves shelve_pictures(std::span<const SharedPicture> pictures) {
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return pictures[i]->rows; });
  Shelves shelves{std::vector<Place>(pictures.size()), width_of(pictures), 0};
  std::uint32_t column = 0, row = 0;
  for (const std::size_t i : order) {
    const std::uint32_t width = framed(pictures[i]->columns);
    if (column + width > shelves.columns) column = 0, row = shelves.rows;
    shelves.places[i] = {column, row};
    column += width;
    shelves.rows = std::max(shelves.rows, row + framed(pictures[i]->rows));
  }
  return shelves;
}

bool fits(const Shelves& shelves, std::uint64_t budget) {
  return std::max(shelves.columns, shelves.rows) <= materials::kMaxImageSide_px &&
         std::uint64_t{shelves.columns} * shelves.rows <= budget;
}

// The unit normal of a slope: components along rows, up columns and outwards.
TextureImage::Texel normal_of(const std::array<std::int16_t, 2>& slope) {
  const Vec3 normal = unit(Vec3{-slope[0] * kSlopeUnit, slope[1] * kSlopeUnit, 1});
  const auto byte = [](double part) { return static_cast<std::uint8_t>((part + 1) / 2 * 255 + 0.5); };
  return {byte(normal.x), byte(normal.y), byte(normal.z)};
}

void draw_picture(const Picture& picture, Place place, Atlas& atlas) {
  for (std::uint32_t y = 0; y < framed(picture.rows); ++y)
    for (std::uint32_t x = 0; x < framed(picture.columns); ++x) {
      const std::size_t row = std::clamp(y, 1u, picture.rows) - 1, column = std::clamp(x, 1u, picture.columns) - 1;
      const Texel& texel = picture.texels[row * picture.columns + column];
      const std::size_t at = std::size_t{place.row + y} * atlas.colour.columns + place.column + x;
      atlas.colour.texels[at] = srgb_of(texel.light);
      atlas.surface.texels[at] = {255, texel.roughness, texel.metalness};
      if (!atlas.emission.texels.empty()) atlas.emission.texels[at] = srgb_of(texel.emission);
      if (!atlas.normal.texels.empty()) atlas.normal.texels[at] = normal_of(texel.slope);
    }
}

// The distinct pictures, and the index among them of every picture.
struct Unique {
  std::vector<SharedPicture> pictures;
  std::vector<std::size_t> number;
};

// Most pictures that are equal are one object, which is not compared byte by byte.
Unique unique_of(std::span<const SharedPicture> pictures) {
  const auto is_less = [](const PackedPicture* a, const PackedPicture* b) { return a != b && *a < *b; };
  std::map<const PackedPicture*, std::size_t, decltype(is_less)> numbers(is_less);
  std::map<const PackedPicture*, std::size_t> seen;
  // numbered by first occurrence: the pictures of a building stay together
  Unique unique;
  for (const SharedPicture& picture : pictures) {
    const auto [known, is_unseen] = seen.try_emplace(picture.get(), 0);
    if (is_unseen) {
      const auto [place, is_new] = numbers.try_emplace(picture.get(), unique.pictures.size());
      if (is_new) unique.pictures.push_back(picture);
      known->second = place->second;
    }
    unique.number.push_back(known->second);
  }
  return unique;
}

bool any_of(std::span<const SharedPicture> pictures, bool PackedPicture::*has) {
  return std::ranges::any_of(pictures, [&](const SharedPicture& p) { return (*p).*has; });
}

bool are_single(std::span<const SharedPicture> pictures) {
  return std::ranges::all_of(pictures, [](const SharedPicture& p) { return p->columns == 1 && p->rows == 1; });
}

}  // namespace

AtlasLayout lay_out_atlas(std::span<const SharedPicture> pictures, double texel_m, std::uint64_t budget) {
  AtlasLayout layout;
  assert(texel_m > 0 &&
         std::ranges::none_of(pictures, [](const SharedPicture& p) { return p->columns * p->rows == 0; }));
  if (pictures.empty()) return layout;
  Unique unique = unique_of(pictures);
  Shelves shelves = shelve_pictures(unique.pictures);
  while (!fits(shelves, budget) && !are_single(unique.pictures)) {
    for (SharedPicture& picture : unique.pictures) picture = shared(halved(unpacked(*picture)));
    texel_m *= 2;
    shelves = shelve_pictures(unique.pictures);
  }
  const auto blank = [&](TextureImage::Texel texel) {
    return materials::blank_image(texel_m, shelves.columns, shelves.rows, texel);
  };
  layout.atlas = {.colour = blank({}), .surface = blank({255, 255, 0}), .emission = {}, .normal = {}};
  if (any_of(unique.pictures, &PackedPicture::has_emission)) layout.atlas.emission = blank({});
  if (any_of(unique.pictures, &PackedPicture::has_slope)) layout.atlas.normal = blank(normal_of({}));
  for (std::size_t i = 0; i < unique.pictures.size(); ++i)
    draw_picture(unpacked(*unique.pictures[i]), shelves.places[i], layout.atlas);
  for (const std::size_t number : unique.number) {
    const Place& place = shelves.places[number];
    layout.at_m.push_back({(place.column + 1) * texel_m, (place.row + 1) * texel_m});
  }
  return layout;
}

}  // namespace citykiln::impostor
