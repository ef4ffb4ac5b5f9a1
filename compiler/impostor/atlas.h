// Texture atlas: the facade pictures of a tile, packed side by side.
//
//     +---------+------+---+      each picture has a frame of one or two texels that repeats its outermost texels;
//     | +-----+ | +--+ |...|      frames begin at even texels and have even widths, so that no texel of the next
//     coarser | |  1  | | |2 | |   |      mip level mixes two pictures | +-----+ | +--+ |   |
//     +---------+------+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// Budget of a tile, frames included: 25 MB of colour and surface before compression, half as much again with emission
/// and normals; 45 MB of graphics memory with mip levels.
inline constexpr std::uint64_t kMaxAtlasTexels = std::uint64_t{1} << 22;
/// Budget of a part of a tile for a view, whose cells have their own: so large that a dense square kilometre keeps the
/// texels that its cells have.
inline constexpr std::uint64_t kMaxViewAtlasTexels = std::uint64_t{1} << 24;

/// Images of one size that do not repeat; all empty if there is no atlas.
struct Atlas {
  materials::TextureImage colour;    ///< sRGB reflectance.
  materials::TextureImage surface;   ///< Linear, as in glTF: occlusion (always 255), roughness, metalness.
  materials::TextureImage emission;  ///< sRGB, 255 = materials::kEmission_cd_m2; empty if nothing emits light.
  materials::TextureImage normal;    ///< As materials::Texture::normal; empty if no texel has a slope.
  bool operator==(const Atlas&) const = default;
};

struct AtlasLayout {
  Atlas atlas;
  std::vector<Vec2> at_m;  ///< For each picture the position of its u = v = 0 in the images.
};

/// Packs pictures into an atlas.
///
/// @param pictures  Each with at least one texel. Equal ones share a place.
/// @param texel_m   Texel size of all pictures, > 0. Doubled, and pictures halved, until the budget holds.
/// @param budget    Texels of the atlas.
///
/// Method: shelf packing by decreasing height into an approximately square atlas.
/// Guarantees: frames do not overlap. The budget holds unless pictures of one texel each exceed it. At the size asked
/// for, every texel of a picture is in the images, rounded to 8 bits once, and is not mixed with another picture in the
/// next mip level. The same bytes on every CPU. O(n log n + texels).
AtlasLayout lay_out_atlas(std::span<const Picture> pictures, double texel_m, std::uint64_t budget = kMaxAtlasTexels);

}  // namespace citykiln::impostor
