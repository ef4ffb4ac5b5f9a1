// A trim sheet: strips of surface side by side, as a texture that repeats along its length. Road markings are drawn
// into one; a tile has at most one.
//
//     columns of texels ->  u, metres across
//     +------+--------+----+
//     |  |   | |    | |    |   v, metres along, repeats
//     |      | |  | | |    |   |
//     |  |   | |    | |    |   v
//     +------+--------+----+
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace citykiln::materials {

/// What graphics cards take, across and along; and in all, so that no sheet fills a memory.
inline constexpr std::uint32_t kMaxImageSide_px = 16384;
inline constexpr std::uint64_t kMaxImageTexels = std::uint64_t{1} << 26;

struct TextureImage {
  using Texel = std::array<std::uint8_t, 3>;  ///< sRGB reflectance.

  double texel_m = 0;                   ///< Size of a texel, both ways. > 0 where there are texels.
  std::uint32_t columns = 0, rows = 0;  ///< At most kMaxImageSide_px, and kMaxImageTexels together.
  std::vector<Texel> texels;            ///< Row by row; texel (0, 0) covers u and v from 0 to texel_m.
  bool operator==(const TextureImage&) const = default;
};

}  // namespace citykiln::materials
