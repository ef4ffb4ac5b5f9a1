// Cutouts: pictures with opacity, packed side by side, for alpha-tested cards (leaves, distant trees).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// Texels of lower opacity are discarded.
inline constexpr std::uint8_t kAlphaCutoff = 128;

/// Images that do not repeat.
struct Cutout {
  materials::TextureImage colour{};     ///< sRGB reflectance.
  std::vector<std::uint8_t> opacity{};  ///< One per texel of `colour`.
  materials::TextureImage normal{};     ///< As materials::Texture::normal, with a texel size of its own; may be empty.
  bool operator==(const Cutout&) const = default;
};

struct CutoutLayout {
  Cutout cutout;
  std::vector<Vec2> at_m;  ///< For each picture the position of its u = v = 0.
};

/// Packs pictures as lay_out_atlas() does, without normals.
///
/// Guarantees: as many texels of a picture reach kAlphaCutoff as its samples cover, to one step of the sample counts;
/// frames are transparent; transparent texels have the mean colour, so that filtering adds no dark fringe. O(n log n +
/// texels).
CutoutLayout lay_out_cutout(std::vector<Picture> pictures, double texel_m);

}  // namespace citykiln::impostor
