// The texture atlas of a tile: its facade pictures (baked textures of building faces), packed side by side.
//
//     +---------+------+---+    each picture has a frame of one or two texels that
//     | +-----+ | +--+ |...|    repeats its outermost texels; frames begin at even
//     | |  1  | | |2 | |   |    texels and have even widths, so that no texel of the
//     | +-----+ | +--+ |   |    next coarser mip level mixes two pictures
//     +---------+------+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// The budget of a tile in texels, frames included: 25 MB of colour and surface before compression, half as much again
/// with emission and normals; 45 MB of graphics memory with mip levels.
inline constexpr std::uint64_t kMaxAtlasTexels = std::uint64_t{1} << 22;
/// The budget of a part of a tile that is baked for a view. It is so large that a dense square kilometre keeps the
/// texels that its cells have when baked alone.
inline constexpr std::uint64_t kMaxViewAtlasTexels = std::uint64_t{1} << 24;

/// The images of an atlas, of one size, which do not repeat. All are empty if there is no atlas.
struct Atlas {
  materials::TextureImage colour;    ///< sRGB reflectance.
  materials::TextureImage surface;   ///< Linear, as in glTF: occlusion (always 255), roughness, metalness.
  materials::TextureImage emission;  ///< sRGB, 255 = materials::kEmission_cd_m2; empty if nothing emits light.
  /// Normals in the format of materials::Texture::normal; empty if no texel has a slope.
  materials::TextureImage normal;
  bool operator==(const Atlas&) const = default;
};

struct AtlasLayout {
  Atlas atlas;
  std::vector<Vec2> at_m;  ///< The position in the images of each picture's u = v = 0.
};

/// Packs pictures into an atlas.
///
/// @param pictures  Not null, and each has at least one texel. Equal pictures share a position.
/// @param texel_m  The texel size of all pictures, > 0. It is doubled, and pictures are halved, until the budget holds.
/// @param budget  The largest number of texels in the atlas.
///
/// Method: shelf packing by decreasing height into an approximately square atlas.
/// Guarantees: frames do not overlap. The budget holds unless pictures of one texel each exceed it. At the requested
/// texel size, every texel of a picture is in the images, rounded to 8 bits once, and is not mixed with another picture
/// in the next mip level. Deterministic on every CPU. O(n log n + texels).
AtlasLayout lay_out_atlas(std::span<const SharedPicture> pictures, double texel_m,
                          std::uint64_t budget = kMaxAtlasTexels);

}  // namespace citykiln::impostor
