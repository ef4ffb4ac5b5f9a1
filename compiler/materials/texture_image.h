// Texture images with a texel size in metres: road markings, facade atlases, cutouts, textures of materials.
//
//     columns of texels ->  u, metres
//     +------+--------+----+
//     |  |   | |    | |    |   v, metres; marking atlases repeat along v
//     |      | |  | | |    |   |
//     |  |   | |    | |    |   v
//     +------+--------+----+
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace citykiln::materials {

/// The largest width and height of an image that graphics cards support, in texels.
inline constexpr std::uint32_t kMaxImageSide_px = 16384;
/// The largest number of texels of an image, a limit for memory.
inline constexpr std::uint64_t kMaxImageTexels = std::uint64_t{1} << 26;

struct TextureImage {
  using Texel = std::array<std::uint8_t, 3>;  ///< sRGB reflectance, unless the user of the image says otherwise.

  double texel_m = 0;                   ///< Size of a texel, both ways. > 0 if there are texels.
  std::uint32_t columns = 0, rows = 0;  ///< At most kMaxImageSide_px, and kMaxImageTexels together.
  std::vector<Texel> texels;            ///< Row by row; texel (0, 0) covers u and v from 0 to texel_m.
  bool operator==(const TextureImage&) const = default;
};

/// The step of texture coordinates on atlases and cutouts, metres (bake/image_uvs.h). In general not a power of two.
/// Single precision resolves it below 2^22 steps, which are 10 km at texels of 2 cm.
inline double uv_step_m(const TextureImage& image) { return image.texel_m / 8; }

}  // namespace citykiln::materials
