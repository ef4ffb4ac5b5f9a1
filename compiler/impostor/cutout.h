// A cutout: pictures side by side that are not everywhere. Leaves, and trees seen from afar, are cut out of flat cards
// by them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// What is less opaque than this is not there.
inline constexpr std::uint8_t kAlphaCutoff = 128;

/// Colours, and how much of each texel there is. It does not repeat.
struct Cutout {
  materials::TextureImage colour{};     ///< sRGB reflectance.
  std::vector<std::uint8_t> opacity{};  ///< One a texel.
  /// As materials::Texture::normal; texels of a size of their own. Or none.
  materials::TextureImage normal{};
  bool operator==(const Cutout&) const = default;
};

struct CutoutLayout {
  Cutout cutout;
  std::vector<Vec2> at_m;  ///< Of each picture's u = v = 0.
};

/// Puts pictures on a cutout as lay_out_atlas() does on an atlas; without normals.
///
/// Guarantees: of each picture as many texels are at least kAlphaCutoff opaque as its samples cover, to one in a count
/// of samples; what is beside a picture is not opaque; what is not there has the colour of what is, so that smoothing
/// brings no dark rim. O(n log n) and texels.
CutoutLayout lay_out_cutout(std::vector<Picture> pictures, double texel_m);

}  // namespace citykiln::impostor
