#include "exporters/gltf/pictures/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <unordered_map>

namespace citykiln::exporters {
namespace {

using materials::TextureImage;

// An image header for libpng.
png_image png_image_of(const TextureImage& sheet) {
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  picture.width = sheet.columns, picture.height = sheet.rows, picture.format = PNG_FORMAT_RGB;
  return picture;
}

std::uint32_t packed(TextureImage::Texel texel) { return std::uint32_t{texel[0]} << 16 | texel[1] << 8 | texel[2]; }

// Sorted colours, and the index of each.
struct Palette {
  std::vector<TextureImage::Texel> colours;
  std::unordered_map<std::uint32_t, std::uint8_t> numbers;
};

// Returns nothing where there are more than 256 colours.
std::optional<Palette> palette_of(const TextureImage& sheet) {
  constexpr std::size_t kMost = 256;
  Palette palette;
  for (const TextureImage::Texel& texel : sheet.texels) {
    if (!palette.numbers.try_emplace(packed(texel)).second) continue;
    if (palette.numbers.size() > kMost) return std::nullopt;
    palette.colours.push_back(texel);
  }
  std::ranges::sort(palette.colours);
  for (std::size_t i = 0; i < palette.colours.size(); ++i)
    palette.numbers[packed(palette.colours[i])] = static_cast<std::uint8_t>(i);
  return palette;
}

std::vector<std::byte> written(png_image& picture, const void* pixels, const void* palette) {
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(picture);
  std::vector<std::byte> bytes(size);
  [[maybe_unused]] const int done = png_image_write_to_memory(&picture, bytes.data(), &size, 0, pixels, 0, palette);
  assert(done != 0);
  bytes.resize(size);
  return bytes;
}

// An upper bound: eight pixels per byte, which deflate compresses at most 1032 times.
std::uint64_t most_texels_in_png(std::size_t bytes) {
  return std::min<std::uint64_t>(8 * 1032 * bytes, materials::kMaxImageTexels);
}

// Reads the header and checks the size. libpng keeps the address of `picture`, which must not move.
Result<Done> begin(png_image& picture, std::span<const std::byte> bytes, const std::string& name) {
  picture.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&picture, bytes.data(), bytes.size()) == 0)
    return Error{name, std::string("expected a PNG picture: ") + picture.message};
  const std::uint64_t texels = std::uint64_t{picture.width} * picture.height;
  if (std::max(picture.width, picture.height) <= materials::kMaxImageSide_px &&
      texels <= most_texels_in_png(bytes.size()))
    return Done{};
  png_image_free(&picture);
  return Error{name, "expected a picture of no more texels than an image may have"};
}

}  // namespace

std::vector<std::byte> encode_png(const TextureImage& sheet) {
  assert(sheet.texels.size() == std::size_t{sheet.columns} * sheet.rows && !sheet.texels.empty());
  png_image picture = png_image_of(sheet);
  const std::optional<Palette> palette = palette_of(sheet);
  if (!palette) return written(picture, sheet.texels.data(), nullptr);
  std::vector<std::uint8_t> numbers;
  numbers.reserve(sheet.texels.size());
  for (const TextureImage::Texel& texel : sheet.texels) numbers.push_back(palette->numbers.at(packed(texel)));
  picture.format = PNG_FORMAT_RGB_COLORMAP;
  picture.colormap_entries = static_cast<png_uint_32>(palette->colours.size());
  return written(picture, numbers.data(), palette->colours.data());
}

std::vector<std::byte> encode_png(const TextureImage& sheet, std::span<const std::uint8_t> opacity) {
  assert(sheet.texels.size() == opacity.size() && !sheet.texels.empty());
  png_image picture = png_image_of(sheet);
  picture.format = PNG_FORMAT_RGBA;
  std::vector<std::array<std::uint8_t, 4>> pixels(opacity.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto& [r, g, b] = sheet.texels[i];
    pixels[i] = {r, g, b, opacity[i]};
  }
  return written(picture, pixels.data(), nullptr);
}

Result<TextureImage> decode_png(std::span<const std::byte> bytes, const std::string& name) {
  png_image picture{};
  if (const auto begun = begin(picture, bytes, name); !begun) return begun.error();
  TextureImage sheet{0, picture.width, picture.height,
                     std::vector<TextureImage::Texel>(std::size_t{picture.width} * picture.height)};
  picture.format = PNG_FORMAT_RGB;
  const png_color black{};
  if (png_image_finish_read(&picture, &black, sheet.texels.data(), 0, nullptr) == 0)
    return Error{name, std::string("expected a whole PNG picture: ") + picture.message};
  return sheet;
}

Result<CutoutImage> decode_cutout_png(std::span<const std::byte> bytes, const std::string& name) {
  png_image picture{};
  if (const auto begun = begin(picture, bytes, name); !begun) return begun.error();
  std::vector<std::array<std::uint8_t, 4>> pixels(std::size_t{picture.width} * picture.height);
  picture.format = PNG_FORMAT_RGBA;
  if (png_image_finish_read(&picture, nullptr, pixels.data(), 0, nullptr) == 0)
    return Error{name, std::string("expected a whole PNG picture: ") + picture.message};
  CutoutImage cut;
  cut.colour.columns = picture.width, cut.colour.rows = picture.height;
  for (const auto& [r, g, b, opacity] : pixels) cut.colour.texels.push_back({r, g, b}), cut.opacity.push_back(opacity);
  return cut;
}

}  // namespace citykiln::exporters
