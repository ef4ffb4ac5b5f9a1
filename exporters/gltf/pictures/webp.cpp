#include "exporters/gltf/pictures/webp.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace citykiln::exporters {
namespace {

using materials::TextureImage;
using Pixel = std::array<std::uint8_t, 4>;

std::vector<Pixel> pixels_of(const TextureImage& image, std::span<const std::uint8_t> opacity) {
  assert(image.texels.size() == std::size_t{image.columns} * image.rows && !image.texels.empty());
  assert(opacity.empty() || opacity.size() == image.texels.size());
  std::vector<Pixel> pixels(image.texels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto& [r, g, b] = image.texels[i];
    pixels[i] = {r, g, b, opacity.empty() ? std::uint8_t{255} : opacity[i]};
  }
  return pixels;
}

std::vector<std::byte> encoded(const TextureImage& image, const std::vector<Pixel>& pixels, const WebPConfig& config) {
  WebPPicture picture;
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  [[maybe_unused]] bool is_done = WebPPictureInit(&picture) != 0;
  picture.use_argb = config.lossless;
  picture.width = static_cast<int>(image.columns), picture.height = static_cast<int>(image.rows);
  picture.writer = WebPMemoryWrite, picture.custom_ptr = &writer;
  is_done = is_done && WebPPictureImportRGBA(&picture, pixels.front().data(), 4 * picture.width) != 0 &&
            WebPEncode(&config, &picture) != 0;
  assert(is_done);
  const auto* first = reinterpret_cast<const std::byte*>(writer.mem);
  std::vector<std::byte> bytes(first, first + writer.size);
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&writer);
  return bytes;
}

// A few bytes can hold an image of one colour of any size, which must not take memory without limit.
std::uint64_t most_texels_in_webp(std::size_t bytes) {
  constexpr std::uint64_t kAnyFile = std::uint64_t{1} << 20, kPerByte = 4096;
  return std::clamp<std::uint64_t>(kPerByte * bytes, kAnyFile, materials::kMaxImageTexels);
}

}  // namespace

std::vector<std::byte> encode_webp(const TextureImage& image, int quality) {
  WebPConfig config;
  WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, static_cast<float>(quality));
  config.method = 2, config.thread_level = 0;
  return encoded(image, pixels_of(image, {}), config);
}

std::vector<std::byte> encode_lossless_webp(const TextureImage& image, std::span<const std::uint8_t> opacity) {
  WebPConfig config;
  WebPConfigInit(&config);
  constexpr int kEffort = 3;
  WebPConfigLosslessPreset(&config, kEffort);
  config.exact = 1, config.thread_level = 0;
  return encoded(image, pixels_of(image, opacity), config);
}

Result<CutoutImage> decode_webp(std::span<const std::byte> bytes, const std::string& name) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK || features.has_animation != 0)
    return Error{name, "expected a WebP picture"};
  const auto columns = static_cast<std::uint32_t>(features.width), rows = static_cast<std::uint32_t>(features.height);
  const std::uint64_t texels = std::uint64_t{columns} * rows;
  if (std::max(columns, rows) > materials::kMaxImageSide_px || texels > most_texels_in_webp(bytes.size()))
    return Error{name, "expected a picture of no more texels than an image may have"};
  std::vector<Pixel> pixels(texels);
  const std::size_t size = pixels.size() * sizeof(Pixel);
  if (WebPDecodeRGBAInto(data, bytes.size(), pixels.front().data(), size, 4 * features.width) == nullptr)
    return Error{name, "expected a whole WebP picture"};
  CutoutImage image;
  image.colour.columns = columns, image.colour.rows = rows;
  for (const auto& [r, g, b, opacity] : pixels)
    image.colour.texels.push_back({r, g, b}), image.opacity.push_back(opacity);
  return image;
}

}  // namespace citykiln::exporters
