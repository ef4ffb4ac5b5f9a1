#include "exporters/gltf/pictures/picture_formats.h"

#include <array>

#include "exporters/gltf/pictures/jpeg.h"
#include "exporters/gltf/pictures/webp.h"

namespace citykiln::exporters {
namespace {

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
