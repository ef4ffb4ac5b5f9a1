// An atlas: pictures side by side on one sheet, for all that a tile shows of imprints.
//
//     +---------+------+---+      each picture in a frame of one texel or two, its outermost texels repeated; frames
//     | +-----+ | +--+ |...|      begin at even texels and are an even number of them wide: so no texel of the next
//     | |  1  | | |2 | |   |      coarser mip level belongs to two pictures
//     | +-----+ | +--+ |   |
//     +---------+------+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// The budget of a tile, all of its frames counted: 3 bytes of colour and 3 of what else it is like, each, are 25 MB
/// before they are packed; by night, and with normals, half as much again. On a graphics card, with mip levels, 45 MB.
inline constexpr std::uint64_t kMaxAtlasTexels = std::uint64_t{1} << 22;

/// Sheets of the same texels, which do not repeat; or none.
struct Atlas {
  materials::TextureImage colour;    ///< sRGB reflectance.
  materials::TextureImage surface;   ///< Linear: 255 (nothing is hidden), roughness, metalness; as glTF has them.
  materials::TextureImage emission;  ///< sRGB, of materials::kEmission_cd_m2; no texels where nothing shines.
  materials::TextureImage normal;    ///< As materials::Texture::normal; no texels where nothing leans.
  bool operator==(const Atlas&) const = default;
};

struct AtlasLayout {
  Atlas atlas;
  std::vector<Vec2> at_m;  ///< Of each picture's u = v = 0 on the sheets.
};

/// Puts pictures on an atlas.
///
/// @param pictures  With texels. Those that are equal are on it once.
/// @param texel_m   Of all. Where the budget would not hold it is doubled, and doubled again, and pictures are halved.
///
/// Method: shelves, the tallest pictures first; the atlas is about as wide as high.
/// Guarantees: frames do not overlap; the budget holds where pictures of one texel do, or the coarsest possible is
/// taken; at the texel asked for every texel of a picture is on the sheets, rounded to 8 bits once; from there to the
/// next mip level none is mixed with another picture's. The same bytes on every CPU; equal pictures share a place.
/// O(n log n) and texels.
AtlasLayout lay_out_atlas(std::span<const Picture> pictures, double texel_m);

}  // namespace citykiln::impostor
