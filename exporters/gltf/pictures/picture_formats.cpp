#include "exporters/gltf/pictures/picture_formats.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "exporters/gltf/pictures/jpeg.h"

namespace citykiln::exporters {
namespace {

// Encodes and decodes texture images as WebP files, for readers that support EXT_texture_webp.

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

// Encodes an image with lossy compression.
// @param quality  1 … 100, of libwebp's scale.
std::vector<std::byte> encode_webp(const TextureImage& image, int quality) {
  WebPConfig config;
  WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, static_cast<float>(quality));
  config.method = 2, config.thread_level = 0;
  return encoded(image, pixels_of(image, {}), config);
}

// Encodes an image with lossless compression.
// @param opacity  Empty (opaque), or one per texel, 255 = opaque. The colours of texels with opacity 0 are stored too.
std::vector<std::byte> encode_lossless_webp(const materials::TextureImage& image,
                                            std::span<const std::uint8_t> opacity = {}) {
  WebPConfig config;
  WebPConfigInit(&config);
  constexpr int kEffort = 3;
  WebPConfigLosslessPreset(&config, kEffort);
  config.exact = 1, config.thread_level = 0;
  return encoded(image, pixels_of(image, opacity), config);
}

// Decodes any WebP that is not an animation, into colours and opacities. Images without alpha are opaque. A file does
// not tell the size of a texel in metres, so TextureImage::texel_m is 0. Errors: bytes that are not a WebP image, an
// animation, or more texels than materials::kMaxImageTexels. Never crashes.
// @param name  The name of the file in error messages.
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

constexpr std::string_view kPngType = "image/png", kJpegType = "image/jpeg", kWebpType = "image/webp";

// Where the loss is below the grain of textures, and below the step of 16 colours of their palette.
constexpr int kJpegQuality = 80, kAtlasJpegQuality = 88, kWebpQuality = 82, kAtlasWebpQuality = 90;

bool begins_with(std::span<const std::byte> bytes, std::span<const std::uint8_t> magic) {
  if (bytes.size() < magic.size()) return false;
  for (std::size_t i = 0; i < magic.size(); ++i)
    if (std::to_integer<std::uint8_t>(bytes[i]) != magic[i]) return false;
  return true;
}

constexpr std::array<std::uint8_t, 3> kJpegMagic = {0xff, 0xd8, 0xff};
constexpr std::array<std::uint8_t, 4> kWebpMagic = {'R', 'I', 'F', 'F'};

Result<CutoutImage> opaque(Result<materials::TextureImage> image) {
  if (!image) return image.error();
  const std::size_t texels = image->texels.size();
  return CutoutImage{std::move(*image), std::vector<std::uint8_t>(texels, 255)};
}

}  // namespace

EncodedPicture encode_picture(const materials::TextureImage& image, std::span<const std::uint8_t> opacity,
                              PictureContent content, PictureFormats formats) {
  const bool is_exact = content == PictureContent::kExact || !opacity.empty();
  const bool is_atlas = content == PictureContent::kAtlas;
  if (formats == PictureFormats::kWebp)
    return {is_exact ? encode_lossless_webp(image, opacity)
                     : encode_webp(image, is_atlas ? kAtlasWebpQuality : kWebpQuality),
            kWebpType};
  if (formats == PictureFormats::kPngAndJpeg && !is_exact)
    return {is_atlas ? encode_jpeg(image, kAtlasJpegQuality, JpegChroma::kFull)
                     : encode_jpeg(image, kJpegQuality, JpegChroma::kHalf),
            kJpegType};
  return {opacity.empty() ? encode_png(image) : encode_png(image, opacity), kPngType};
}

Result<CutoutImage> decode_picture(std::span<const std::byte> bytes, const std::string& name) {
  if (begins_with(bytes, kJpegMagic)) return opaque(decode_jpeg(bytes, name));
  if (begins_with(bytes, kWebpMagic)) return decode_webp(bytes, name);
  return decode_cutout_png(bytes, name);
}

}  // namespace citykiln::exporters
