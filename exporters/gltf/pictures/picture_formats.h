// The file formats of a .glb's images: chooses one to write an image, and reads all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"
#include "exporters/gltf/pictures/png.h"

namespace citykiln::exporters {

/// The formats that a .glb may use.
enum class PictureFormats : std::uint8_t {
  kPng,         ///< PNG only: lossless.
  kPngAndJpeg,  ///< JPEG for opaque colours, PNG for the rest. All glTF readers support both.
  kWebp         ///< WebP by EXT_texture_webp: lossy for opaque colours, lossless for the rest.
};

/// The extension of textures in WebP. It is required, since they have no other image.
inline constexpr const char* kWebpExtension = "EXT_texture_webp";

/// The content of an image, which decides how lossy its format may be.
enum class PictureContent : std::uint8_t {
  kExact,   ///< Normals, roughness, opacities, and images of few colours.
  kColour,  ///< Colours of a texture that repeats.
  kAtlas    ///< Colours of pictures side by side, which must not bleed into each other.
};

struct EncodedPicture {
  std::vector<std::byte> bytes;
  std::string_view mime_type;
};

/// Encodes an image. Cannot fail.
///
/// @param opacity  Empty, or one per texel.
EncodedPicture encode_picture(const materials::TextureImage& image, std::span<const std::uint8_t> opacity,
                              PictureContent content, PictureFormats formats);

/// Decodes an image in any of the formats, told apart by its first bytes. Errors: those of decode_png(), decode_jpeg()
/// and decode_webp().
Result<CutoutImage> decode_picture(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters
