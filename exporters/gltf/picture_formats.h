// File formats of a .glb's images: which one an image is written in, and reading whichever it is in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"
#include "exporters/gltf/png.h"

namespace citykiln::exporters {

/// Which formats a .glb may use.
enum class PictureFormats : std::uint8_t {
  kPng,         ///< PNG alone: nothing is lost.
  kPngAndJpeg,  ///< JPEG for opaque colours, PNG for the rest. All readers of glTF know both.
  kWebp         ///< WebP for all, by EXT_texture_webp: with loss for opaque colours, lossless for the rest.
};

/// The extension that textures in WebP need, which is required, since they have no other image.
inline constexpr const char* kWebpExtension = "EXT_texture_webp";

/// What an image holds, which decides how much it may lose.
enum class PictureContent : std::uint8_t {
  kExact,   ///< Normals, roughness, opacities, and images of few colours.
  kColour,  ///< Colours of a texture that repeats.
  kAtlas    ///< Colours of pictures side by side, of which none may tinge the next.
};

struct EncodedPicture {
  std::vector<std::byte> bytes;
  std::string_view mime_type;
};

/// Encodes an image. @param opacity  Empty, or one per texel.
EncodedPicture encode_picture(const materials::TextureImage& image, std::span<const std::uint8_t> opacity,
                              PictureContent content, PictureFormats formats);

/// Decodes an image in any of the formats, by its first bytes. Errors: as decode_png(), decode_jpeg(), decode_webp().
Result<CutoutImage> decode_picture(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters
